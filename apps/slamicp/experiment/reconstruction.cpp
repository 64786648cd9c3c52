// SPDX-License-Identifier: Apache-2.0
#include <slamicp/evaluation/measured_size.hpp>
#include <slamicp/evaluation/recorded_drive.hpp>
#include <slamicp/simulation/corridor_world.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

/// A drive gives hundreds of points a square centimetre of what stands there, few of what a beam mixed at an edge.
ReconstructionOptions filter() {
  ReconstructionOptions options;
  options.filter_radius = 0.02;
  options.filter_neighbours = 30;
  return options;
}

std::string size_text(const PlacedObstacle& placed) {
  if (!placed.boxes.empty())
    return format("%.0f x %.0f mm", 1e3 * placed.boxes.front().width, 1e3 * placed.boxes.front().depth);
  return format("radius %.0f mm", 1e3 * placed.cylinders.front().radius);
}

std::string size_text(const MeasuredThing& thing, bool is_box) {
  std::string box = format("%.0f x %.0f mm", 1e3 * thing.box.width, 1e3 * thing.box.depth);
  if (is_box || !thing.round) return box;
  return format("radius %.0f mm (circle), ", 1e3 * thing.round->radius) + box + " (box)";
}

void add_outline(Picture& picture, const PlacedObstacle& placed) {
  std::vector<Picture::Segment> outline;
  for (const Box& box : placed.boxes)
    for (const Segment& side : sides(box)) outline.push_back({side.a, side.b});
  if (!outline.empty()) picture.segments(outline, colours::obstacle, 1.5, "as it stands");
  for (const Cylinder& cylinder : placed.cylinders)
    picture.circle(cylinder.centre, cylinder.radius, colours::obstacle, 1.5, "as it stands");
}

Point2 centre_of(const PlacedObstacle& placed) {
  return placed.boxes.empty() ? placed.cylinders.front().centre : placed.boxes.front().centre;
}

Picture draw(const ExperimentSite& site, const RecordedDrive& drive, const MeasuredThing& thing,
             const std::string& title) {
  const PlacedObstacle placed = corridor_obstacle(drive.plan.obstacle);
  const double half = placed.boxes.empty() ? 0.35 : 0.7;
  const Point2 centre = centre_of(placed);
  const Vector<2> reach(1.5 * half, half);
  Picture picture = draw_map(site, title, Bounds<2>{centre - reach, centre + reach});
  picture.points(drive.outliers, Colour{214, 39, 40, 0.35}, 1.2,
                 format("%zu outliers of the drive", drive.outliers.size()));
  picture.points(thing.points, colours::outlier, 1.4, format("%zu after the filter", thing.points.size()));
  add_outline(picture, placed);
  return picture;
}

/// One drive past one obstacle, and what its outliers add up to.
struct Reconstruction {
  PlacedObstacle placed;
  RecordedDrive drive;
  std::optional<MeasuredThing> thing;

  bool is_box() const { return !placed.boxes.empty(); }
  double radius() const { return !is_box() && thing->round ? thing->round->radius : 0.0; }
  std::string measured() const { return thing ? size_text(*thing, is_box()) : std::string("not found"); }
};

Reconstruction reconstruct(const ExperimentSite& site, const std::string& obstacle, double outlier_distance,
                           std::uint64_t seed) {
  DrivePlan plan;
  plan.obstacle = obstacle;
  plan.seed = seed;
  plan.outlier_distance = outlier_distance;
  Reconstruction made{corridor_obstacle(obstacle), record_drive(site, plan), {}};
  made.thing = measured_thing(made.drive.outliers, made.placed, filter());
  return made;
}

constexpr const char* csv_header =
    "obstacle,outlier_distance_m,outliers,points,true_width_m,true_depth_m,true_radius_m,width_m,depth_m,heading_rad,"
    "radius_m\n";

std::string csv_row(const Reconstruction& made) {
  const MeasuredThing& thing = *made.thing;
  const bool is_box = made.is_box();
  return format("%s,%.2f,%zu,%zu,%.3f,%.3f,%.3f,%.4f,%.4f,%.4f,%.4f\n", made.placed.name.c_str(),
                made.drive.plan.outlier_distance, made.drive.outliers.size(), thing.points.size(),
                is_box ? made.placed.boxes[0].width : 0.0, is_box ? made.placed.boxes[0].depth : 0.0,
                is_box ? 0.0 : made.placed.cylinders[0].radius, thing.box.width, thing.box.depth, thing.box.heading,
                made.radius());
}

std::vector<std::string> cells(const Reconstruction& made) {
  return {made.placed.name,
          size_text(made.placed),
          format("%.1f", made.drive.plan.outlier_distance),
          format("%zu", made.drive.outliers.size()),
          format("%zu", made.thing ? made.thing->points.size() : 0),
          made.measured()};
}

Json thing_json(const Reconstruction& made) {
  return {{"obstacle", made.placed.name},
          {"outlier_distance", made.drive.plan.outlier_distance},
          {"outliers", made.drive.outliers.size()},
          {"points", made.thing->points.size()},
          {"width", made.thing->box.width},
          {"depth", made.thing->box.depth},
          {"radius", made.radius()}};
}

void add_figure(const ExperimentSite& site, const Reconstruction& made, const Folder& folder, Page& page) {
  const char* name = made.placed.name.c_str();
  const double distance = made.drive.plan.outlier_distance;
  const Picture picture = draw(site, made.drive, *made.thing,
                               format("Figure 16: %s, outliers at least %.1f m from the map", name, distance));
  folder.save(format("reconstruction_%s_%.0fcm", name, 100.0 * distance), picture);
  page.figure(picture.svg(), format("%s, outlier distance %.1f m: ", name, distance) + made.measured());
}

void introduce_reconstruction(Page& page, const ExperimentSite& site) {
  tell_what_is_simulated(page, site);
  page.paragraph(
      "The outliers of all scans of a drive at 0.35 m/s, in the map; a point is kept that has 30 others within 2 cm. "
      "An "
      "outlier is a point at least so far from every map point: 0.3 m, the paper's, hides what stands nearer to a "
      "wall, "
      "as half of A2 does here; 0.1 m shows more of it. The paper's Figure 16 shows the shapes of A2 and B2 and gives "
      "no measures. The map is off by what the exploration left, so shapes stand beside the truth by as much; range "
      "errors of 10 mm, to either side, make a box larger and are a quarter of B2's radius. B2 is measured twice: by "
      "the circle through its points, and by the box around them.");
}

}  // namespace

Json run_reconstruction(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder,
                        const Talk& talk) {
  Page page("Figure 16: obstacles rebuilt from the outliers of a drive");
  introduce_reconstruction(page, site);
  std::vector<std::vector<std::string>> rows{
      {"obstacle", "true size", "outlier distance m", "outliers", "after the filter", "measured"}};
  std::string csv = csv_header;
  Json things = Json::array();
  for (const std::string& obstacle : words.obstacles_or({"A2", "B2"})) {
    for (const double outlier_distance : {0.3, 0.1}) {
      const Reconstruction made = reconstruct(site, obstacle, outlier_distance, words.seed);
      rows.push_back(cells(made));
      talk(format("%-9s %s; outlier distance %.1f m: %s", obstacle.c_str(), size_text(made.placed).c_str(),
                  outlier_distance, made.measured().c_str()));
      if (!made.thing) continue;
      csv += csv_row(made);
      things.push_back(thing_json(made));
      add_figure(site, made, folder, page);
    }
  }
  page.heading("Sizes").table(rows);
  folder.save_text("reconstruction.csv", csv);
  folder.save_text("reconstruction.html", page.html());
  return {{"things", things}};
}

}  // namespace slamicp::command
