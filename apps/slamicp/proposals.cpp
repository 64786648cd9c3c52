// SPDX-License-Identifier: Apache-2.0
#include "proposals.hpp"

#include <cmath>
#include <filesystem>

#include <slamicp/io/output_file.hpp>

#include "output.hpp"

namespace slamicp::command {
namespace {

Json proposal_json(const ProposedChange& change) {
  Json points = Json::array();
  for (const Point2& point : change.points)
    points.push_back({std::round(1e4 * point.x()) / 1e4, std::round(1e4 * point.y()) / 1e4});
  return {{"kind", to_string(change.kind)},
          {"x", change.box.centre.x()},
          {"y", change.box.centre.y()},
          {"width", change.box.width},
          {"depth", change.box.depth},
          {"heading", change.box.heading},
          {"evidence",
           {{"scans", change.scans},
            {"share", change.share},
            {"first_stamp", change.first_stamp},
            {"last_stamp", change.last_stamp},
            {"baseline", change.baseline}}},
          {"points", points},
          {"map_index", change.map_index}};
}

/// The outline of a box, a little outside of it.
std::vector<Point2> proposal_outline(const OrientedBox& box) {
  constexpr double beside = 0.08;
  const Pose2 pose{box.centre.x(), box.centre.y(), box.heading};
  const double x = 0.5 * box.width + beside, y = 0.5 * box.depth + beside;
  return {pose * Point2(x, y), pose * Point2(-x, y), pose * Point2(-x, -y), pose * Point2(x, -y), pose * Point2(x, y)};
}

Picture draw_proposals(const RunRecord& record, std::span<const ProposedChange> proposals) {
  Picture picture({.title = format("%zu changes of the map proposed", proposals.size())});
  picture.points(record.map->points(), colours::map, 0.9, "map");
  picture.path(record.trajectory, colours::path, 1.0, "path");
  for (const ProposedChange::Kind kind : {ProposedChange::Kind::add, ProposedChange::Kind::remove}) {
    const Colour colour = kind == ProposedChange::Kind::add ? colours::outlier : colours::obstacle;
    std::string legend = kind == ProposedChange::Kind::add ? "to add" : "to remove";
    for (const ProposedChange& change : proposals) {
      if (change.kind != kind) continue;
      picture.points(change.points, colour, 1.8, legend);
      picture.polyline(proposal_outline(change.box), colour, 1.2);
      legend.clear();
    }
  }
  return picture;
}

}  // namespace

void write_proposals(const std::string& file, const RunRecord& record, std::span<const ProposedChange> proposals) {
  Json list = Json::array();
  for (const ProposedChange& change : proposals) list.push_back(proposal_json(change));
  write_file(file_named(file), Json{{"log", record.log}, {"map", record.map_file}, {"proposals", list}}.dump(1) + "\n");
  draw_proposals(record, proposals).save(file_named(file).replace_extension(".svg"));
}

}  // namespace slamicp::command
