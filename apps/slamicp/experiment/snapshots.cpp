// SPDX-License-Identifier: Apache-2.0
#include <slamicp/evaluation/recorded_drive.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

constexpr const char* letters[] = {"a", "b", "c"};

const char* figure_of(const std::string& obstacle) {
  if (obstacle == "A2") return "10";
  if (obstacle == "B2") return "13";
  return "10, 13";
}

Picture draw(const ExperimentSite& site, const DriveView& view, const std::string& title) {
  Picture picture = draw_map(site, title, Bounds<2>{{2.5, -5.3}, {18.5, 4.9}});
  picture.polyline(path_of(site), colours::path, 1.2, "reference path");
  picture.points(view.inliers, colours::inlier, 1.4, format("%zu inliers", view.inliers.size()));
  picture.points(view.outliers, colours::outlier, 2.0, format("%zu outliers", view.outliers.size()));
  picture.robot(view.pose, 0.25, colours::robot, format("robot after %.1f m", view.travelled));
  return picture;
}

RecordedDrive drive_past(const ExperimentSite& site, const std::string& obstacle, std::uint64_t seed) {
  DrivePlan plan;
  plan.obstacle = obstacle;
  plan.seed = seed;
  plan.views = places_of(obstacle);
  plan.keeps_scans = false;
  return record_drive(site, plan);
}

std::string csv_row(const std::string& obstacle, const char* letter, const DriveView& view) {
  return format("%s,%s,%.3f,%.4f,%.4f,%.5f,%zu,%zu\n", obstacle.c_str(), letter, view.travelled, view.pose.x,
                view.pose.y, view.pose.theta, view.inliers.size(), view.outliers.size());
}

Json view_json(const std::string& obstacle, const char* letter, const DriveView& view) {
  return {{"obstacle", obstacle},           {"label", letter},
          {"travelled", view.travelled},    {"pose", to_json(view.pose)},
          {"inliers", view.inliers.size()}, {"outliers", view.outliers.size()}};
}

void introduce_snapshots(Page& page, const ExperimentSite& site) {
  tell_what_is_simulated(page, site);
  page.paragraph(
      "The robot follows the reference path at 0.35 m/s. (a) it is about to enter the main corridor, (b) it has "
      "entered "
      "it, (c) it sees the obstacle's other side. Outliers, at least 0.3 m from every map point, are red. The paper's "
      "captions say the same of its Figures 10 (box A2) and 13 (cylinder B2); its (c) is near the end of the path. Our "
      "B2 leaves the field of view of 270 deg earlier, so (c) shows it from the last place that sees it well.");
}

}  // namespace

Json run_snapshots(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk) {
  Page page("Figures 10 and 13: what the map does not know, seen from three places");
  introduce_snapshots(page, site);
  std::string csv = "obstacle,label,travelled_m,x,y,theta,inliers,outliers\n";
  Json views = Json::array();
  for (const std::string& obstacle : words.obstacles_or({"A2", "B2"})) {
    const RecordedDrive drive = drive_past(site, obstacle, words.seed);
    const std::string figure = std::string("Figure ") + figure_of(obstacle);
    page.heading(figure + format(": obstacle %s", obstacle.c_str()));
    for (std::size_t k = 0; k < drive.views.size(); ++k) {
      const DriveView& view = drive.views[k];
      const Picture picture = draw(site, view, figure + format("%s: obstacle %s", letters[k], obstacle.c_str()));
      folder.save(format("snapshot_%s_%s", obstacle.c_str(), letters[k]), picture);
      const std::string told =
          format("after %.1f m: %zu inliers, %zu outliers", view.travelled, view.inliers.size(), view.outliers.size());
      page.figure(picture.svg(), format("(%s) ", letters[k]) + told);
      talk(format("%-9s (%s) ", obstacle.c_str(), letters[k]) + told);
      csv += csv_row(obstacle, letters[k], view);
      views.push_back(view_json(obstacle, letters[k], view));
    }
  }
  folder.save_text("snapshots.csv", csv);
  folder.save_text("snapshots.html", page.html());
  return {{"views", views}};
}

}  // namespace slamicp::command
