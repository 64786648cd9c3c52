// SPDX-License-Identifier: Apache-2.0
// the paper's Figures 2, 3 (noise-free scan to scan) and 6 to 8 (map update: all points against outliers), as pictures
//
// Figures 2 and 3 are drawn in a room of our own, like the paper's sketch; 6 to 8 with two scans of the simulated
// corridor, like the paper's real ones: as many points, as much noise, another place.
#include <slamicp/registration/icp.hpp>
#include <slamicp/scan/scan_points.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

/// An L-shaped room: from where the robot starts, a part of it hides behind the corner.
World room() {
  World world;
  world.name = "room";
  const PointCloud2 corners = {{-2.0, -1.5}, {4.0, -1.5}, {4.0, 5.0},  {1.6, 5.0},
                               {1.6, 1.5},   {-2.0, 1.5}, {-2.0, -1.5}};
  for (std::size_t k = 1; k < corners.size(); ++k) world.walls.push_back({corners[k - 1], corners[k]});
  return world;
}

/// Two scans, where the second was really taken, as seen from the first, and where the wheels say it was.
struct Views {
  PointCloud2 M;
  PointCloud2 T;
  Pose2 truth;
  Pose2 guess;
};

Views look(const World& world, const Pose2& first, const Pose2& second, double noise) {
  const LidarModel lidar = hokuyo_utm30lx(noise);
  Random random(1);
  Views views;
  views.M = to_points(scan(world, first, lidar, random)).in_robot;
  views.T = to_points(scan(world, second, lidar, random)).in_robot;
  views.truth = first.inverse() * second;
  views.guess = views.truth * Pose2{0.05, -0.05, 2.0 / deg_per_rad};
  return views;
}

Bounds<2> around(const Views& views) {
  PointCloud2 all = views.M;
  for (const Point2& point : views.T) {
    all.push_back(point);
    all.push_back(views.truth * point);
  }
  Bounds<2> bounds = bounds_of<2>(all);
  bounds.lower.array() -= 0.5;
  bounds.upper.array() += 0.5;
  return bounds;
}

Picture picture(const std::string& title, const Bounds<2>& bounds) {
  PictureOptions options;
  options.title = title;
  options.bounds = bounds;
  options.width_px = 700.0;
  return Picture(options);
}

std::string legend(const char* what, std::size_t points) { return text("%s, %zu points", what, points); }

struct Drawn {
  Views views;
  IcpResult2 result;
  PointCloud2 inliers;
};

Drawn match(Views views) {
  Drawn drawn{std::move(views), {}, {}};
  drawn.result =
      align<2>(drawn.views.T, drawn.views.M, drawn.views.guess, IcpOptions{.max_correspondence_distance = 0.3});
  for (std::size_t i = 0; i < drawn.views.T.size(); ++i)
    if (is_inlier(drawn.result.matches[i].point_class)) drawn.inliers.push_back(drawn.result.transformed_scan[i]);
  return drawn;
}

void draw_scans(const std::string& figure, const Drawn& drawn, const Bounds<2>& bounds) {
  Picture a = picture("Figure " + figure + "a: M, where the robot starts", bounds);
  a.points(drawn.views.M, colours::map, 1.3, legend("M", drawn.views.M.size())).robot({}, 0.15);
  save_picture("figure_" + figure + "a", a);
  Picture b = picture("Figure " + figure + "b: T, after it has moved, as the robot sees it", bounds);
  b.points(drawn.views.T, colours::obstacle, 1.3, legend("T", drawn.views.T.size())).robot({}, 0.15);
  save_picture("figure_" + figure + "b", b);
}

void draw_match(const std::string& figure, const Drawn& drawn, const Bounds<2>& bounds) {
  Picture a = picture("Figure " + figure + "a: tT in M, and the robot's pose", bounds);
  a.points(drawn.views.M, colours::map, 1.3, legend("M", drawn.views.M.size()));
  a.points(drawn.result.transformed_scan, colours::obstacle, 1.1, legend("tT", drawn.result.transformed_scan.size()));
  a.robot({}, 0.15, colours::truth).robot(drawn.result.pose, 0.15);
  save_picture("figure_" + figure + "a", a);
}

void draw_classes(const std::string& figure, const Drawn& drawn, const Bounds<2>& bounds) {
  Picture a = picture("Figure " + figure + "a: inliers and outliers of tT in M", bounds);
  a.points(drawn.views.M, colours::map, 1.3, legend("M", drawn.views.M.size()));
  a.points(drawn.inliers, colours::inlier, 1.1, legend("inliers", drawn.inliers.size()));
  a.points(drawn.result.outliers_in_map, colours::outlier, 1.3,
           legend("outliers", drawn.result.outliers_in_map.size()));
  a.robot({}, 0.15, colours::truth).robot(drawn.result.pose, 0.15);
  save_picture("figure_" + figure + "a", a);
}

void draw_map(const std::string& figure, const std::string& title, const PointCloud2& map, const Bounds<2>& bounds) {
  Picture b = picture("Figure " + figure + "b: " + title, bounds);
  b.points(map, colours::map, 1.1, legend("uM", map.size()));
  save_picture("figure_" + figure + "b", b);
}

PointCloud2 with_all_points(const Drawn& drawn) {
  PointCloud2 map = drawn.views.M;
  map.insert(map.end(), drawn.result.transformed_scan.begin(), drawn.result.transformed_scan.end());
  return map;
}

Json tell(Table& table, const std::string& figures, const Drawn& drawn, const char* paper) {
  const PoseDistance error = distance(drawn.result.pose, drawn.views.truth);
  const std::size_t all = drawn.views.M.size() + drawn.views.T.size();
  const std::size_t thin = drawn.result.updated_map.size();
  table.add({figures, text("%zu", drawn.views.M.size()), text("%zu", drawn.views.T.size()),
             text("%zu", drawn.result.inliers), text("%zu", drawn.result.outlier_indices.size()), text("%zu", all),
             text("%zu", thin), paper, text("%.2f", 1e3 * error.translation),
             text("%.3f", deg_per_rad * error.rotation), text("%d", drawn.result.iterations),
             to_string(drawn.result.stop)});
  return {{"figures", figures},
          {"M", drawn.views.M.size()},
          {"T", drawn.views.T.size()},
          {"inliers", drawn.result.inliers},
          {"outliers", drawn.result.outlier_indices.size()},
          {"updated_all_points", all},
          {"updated_outliers_only", thin},
          {"error_mm", 1e3 * error.translation},
          {"error_deg", deg_per_rad * error.rotation}};
}

void figures() {
  Table table({"figures", "M", "T", "inliers", "outliers", "uM, all points", "uM, outliers only", "paper's two uM",
               "error mm", "error deg", "iterations", "stop"});
  Json results = Json::array();
  {
    const Drawn drawn = match(look(room(), {}, {1.5, 0.3, 0.6}, 0.0));
    const Bounds<2> bounds = around(drawn.views);
    draw_scans("2", drawn, bounds);
    draw_match("3", drawn, bounds);
    draw_map("3", "the updated map", drawn.result.updated_map, bounds);
    results.push_back(tell(table, "2, 3 (no noise)", drawn, "-"));
  }
  {
    const Drawn drawn = match(look(corridor_world(), {5.9, -1.5, 1.5708}, {6.2, 0.4, 0.9}, 0.01));
    const Bounds<2> bounds = around(drawn.views);
    draw_scans("6", drawn, bounds);
    draw_match("7", drawn, bounds);
    draw_map("7", "uM from all points: thick walls", with_all_points(drawn), bounds);
    draw_classes("8", drawn, bounds);
    draw_map("8", "uM from the outliers only", drawn.result.updated_map, bounds);
    results.push_back(tell(table, "6, 7, 8 (1 cm noise)", drawn, "2162, 1617"));
  }
  std::printf("Scan T onto scan M; the guess is off by 5 cm, 5 cm, 2 deg; correspondences and outliers at 0.3 m.\n\n");
  table.print();
  if (const auto folder = out(""); !folder.empty()) std::printf("Pictures: figure_*.svg, .png in %s\n", folder.c_str());
  save_results("figures_2_to_8", results);
}

}  // namespace
}  // namespace slamicp::measure

int main() { return slamicp::measure::run(slamicp::measure::figures); }
