// SPDX-License-Identifier: Apache-2.0
// 3D registration from the identity: small_gicp's pair against its ground truth, PCL's bunny pair
//
// scripts/measure pairs3d [--settings yes]     yes: also other gates, surfaces and voxel phases
#include <fstream>

#include <slamicp/geometry/voxel_grid.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/registration/icp.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

Pose3 load_truth(const std::filesystem::path& file) {
  std::ifstream in(file);
  Matrix<3, 3> rotation;
  Point3 translation;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) in >> rotation(r, c);
    in >> translation[r];
  }
  if (!in) throw std::runtime_error(file.string() + " does not hold a 4x4 matrix");
  return Pose3::from(rotation, translation);
}

struct Pair {
  PointCloud3 source;
  PointCloud3 target;
  Pose3 truth;
};

Pair load_pair() {
  return {load_cloud3(data("registration/small_gicp_source.ply")),
          load_cloud3(data("registration/small_gicp_target.ply")),
          load_truth(data("registration/small_gicp_T_target_source.txt"))};
}

/// Where the cubes of the grid begin is arbitrary: `phase` [m] moves them.
Pair thinned(const Pair& pair, double voxel, double phase = 0.0) {
  const auto thin = [&](PointCloud3 cloud) {
    for (Point3& point : cloud) point.array() += phase;
    cloud = voxel_downsampled<3>(cloud, voxel);
    for (Point3& point : cloud) point.array() -= phase;
    return cloud;
  };
  return {thin(pair.source), thin(pair.target), pair.truth};
}

struct Run {
  double prepare_ms = 0.0;
  double align_ms = 0.0;
  IcpResult3 result;
  PoseDistance error;
};

/// Times are medians of `rounds`.
Run run_pair(const Pair& pair, const IcpOptions& options, const SurfaceOptions& surfaces, int rounds = 5) {
  Run run;
  std::vector<double> prepare, align;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch preparing;
    const IndexedPoints<3> map(pair.target, surfaces);
    prepare.push_back(preparing.milliseconds());
    Icp<3> icp(options);
    const Stopwatch aligning;
    icp.align(map, pair.source, {});
    align.push_back(aligning.milliseconds());
    if (round + 1 == rounds) run.result = icp.align(map, pair.source, {}, {.mean_inlier_distance = true});
  }
  run.prepare_ms = quantile(prepare, 0.5);
  run.align_ms = quantile(align, 0.5);
  run.error = distance(run.result.pose, pair.truth);
  return run;
}

SurfaceOptions no_surfaces() {
  SurfaceOptions surfaces;
  surfaces.neighbours = 0;
  return surfaces;
}

IcpOptions options_for(Method method, double gate) {
  IcpOptions options;
  options.method = method;
  options.max_correspondence_distance = gate;
  options.max_iterations = 100;
  return options;
}

void add_run(Table& table, Json& results, const std::string& name, const Run& run) {
  table.add({name, text("%.1f", 1e3 * run.error.translation), text("%.3f", deg_per_rad * run.error.rotation),
             text("%.1f + %.1f", run.prepare_ms, run.align_ms), text("%d", run.result.iterations),
             to_string(run.result.stop)});
  results.push_back({{"method", name},
                     {"error_mm", 1e3 * run.error.translation},
                     {"error_deg", deg_per_rad * run.error.rotation},
                     {"prepare_ms", run.prepare_ms},
                     {"align_ms", run.align_ms},
                     {"iterations", run.result.iterations},
                     {"stop", to_string(run.result.stop)}});
}

/// Other people's figures for the same clouds and voxel size, one thread, on a machine like ours.
void add_peers(Table& table) {
  table.add({"small_gicp ICP (point-to-point)", "33", "-", "1.1 + 27.6"});
  table.add({"small_gicp PLANE", "15", "-", "8.2 + 13.7"});
  table.add({"small_gicp GICP (the truth looks made by it)", "7", "-", "16.9 + 8.8"});
  table.add({"small_gicp VGICP", "19", "-", "17.8 + 3.7"});
  table.add({"PCL point-to-point / plane / GICP", "-", "-", "126 / 65 / 76 in all"});
  table.add({"Open3D point-to-point / plane", "-", "-", "58 / 54 in all"});
}

Json measure_small_gicp_pair() {
  const Pair pair = thinned(load_pair(), 0.25);
  std::printf(
      "small_gicp's pair, voxel 0.25 m (%zu onto %zu points), from the identity, correspondences within 1 m,\n"
      "against small_gicp_T_target_source.txt; one thread; ms: index and surfaces + match.\n\n",
      pair.source.size(), pair.target.size());
  Table table({"method", "error mm", "error deg", "prepare + align ms", "iterations", "stop"});
  Json results = Json::array();
  add_run(table, results, "**slamicp** point-to-point",
          run_pair(pair, options_for(Method::point_to_point, 1.0), no_surfaces()));
  add_run(table, results, "**slamicp** point-to-plane", run_pair(pair, options_for(Method::point_to_plane, 1.0), {}));
  add_peers(table);
  table.print();
  return results;
}

struct Setting {
  std::string name;
  Method method;
  double final_gate;  // 0: the default
  SurfaceOptions surfaces;
};

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const double gate : {0.0, 0.3, 1.0})
    all.push_back({text("point-to-point, final gate %s", gate > 0.0 ? text("%.1f m", gate).c_str() : "default"),
                   Method::point_to_point, gate, no_surfaces()});
  for (const int neighbours : {8, 12, 20})
    for (const double radius : {0.5, 1.0})
      for (const double gate : {0.0, 1.0})
        all.push_back({text("point-to-plane, %d neighbours within %.1f m, final gate %s", neighbours, radius,
                            gate > 0.0 ? text("%.1f m", gate).c_str() : "default"),
                       Method::point_to_plane,
                       gate,
                       {.neighbours = neighbours, .radius = radius}});
  return all;
}

/// With four phases of the voxel grid, whose spread says how much of an error is chance.
Json measure_settings() {
  std::vector<Pair> pairs;
  for (const double phase : {0.0, 0.0625, 0.125, 0.1875}) pairs.push_back(thinned(load_pair(), 0.25, phase));
  std::printf("The same with other settings, for four phases of the voxel grid: map spacing %.3f m.\n\n",
              IndexedPoints<3>(pairs.front().target, no_surfaces()).spacing());
  Table table({"setting", "error mm (four phases)", "mean mm", "deg", "iterations", "stop"});
  Json results = Json::array();
  for (const Setting& setting : settings()) {
    IcpOptions options = options_for(setting.method, 1.0);
    options.final_gate = setting.final_gate;
    std::vector<double> error, turn;
    std::string each, iterations, stops;
    for (const Pair& pair : pairs) {
      const Run run = run_pair(pair, options, setting.surfaces, 1);
      error.push_back(1e3 * run.error.translation);
      turn.push_back(deg_per_rad * run.error.rotation);
      each += text(each.empty() ? "%.1f" : " %.1f", error.back());
      iterations += text(iterations.empty() ? "%d" : " %d", run.result.iterations);
      if (!run.result.usable() || run.result.stop != Stop::converged)
        stops += std::string(" ") + to_string(run.result.stop);
    }
    table.add({setting.name, each, text("%.1f", mean(error)), text("%.3f", mean(turn)), iterations,
               stops.empty() ? "converged" : stops});
    results.push_back({{"setting", setting.name}, {"error_mm", error}, {"error_deg", turn}});
  }
  table.print();
  return results;
}

Json measure_bunny() {
  const Pair pair{load_cloud3(data("registration/bun4.pcd")), load_cloud3(data("registration/bun0.pcd")), {}};
  std::printf(
      "PCL's bunny, bun4 (%zu points) onto bun0 (%zu), from the identity, correspondences within 0.05 m. Apart:\n"
      "how far the pose is from the point-to-point one.\n\n",
      pair.source.size(), pair.target.size());
  Table table({"method", "inliers", "mean inlier distance mm", "apart mm", "apart deg", "prepare + align ms",
               "iterations", "stop"});
  Json results = Json::array();
  Pose3 first;
  for (const Method method : {Method::point_to_point, Method::point_to_plane}) {
    const bool point = method == Method::point_to_point;
    const Run run = run_pair(pair, options_for(method, 0.05), point ? no_surfaces() : SurfaceOptions{});
    if (point) first = run.result.pose;
    const PoseDistance apart = distance(run.result.pose, first);
    const char* name = point ? "slamicp point-to-point" : "slamicp point-to-plane";
    table.add({name, text("%zu of %zu", run.result.inliers, pair.source.size()),
               text("%.2f", 1e3 * run.result.mean_inlier_distance), text("%.2f", 1e3 * apart.translation),
               text("%.2f", deg_per_rad * apart.rotation), text("%.2f + %.2f", run.prepare_ms, run.align_ms),
               text("%d", run.result.iterations), to_string(run.result.stop)});
    results.push_back({{"method", name},
                       {"inliers", run.result.inliers},
                       {"mean_inlier_distance_mm", 1e3 * run.result.mean_inlier_distance},
                       {"apart_mm", 1e3 * apart.translation},
                       {"apart_deg", deg_per_rad * apart.rotation}});
  }
  table.print();
  return results;
}

void pairs3d(const Words& words) {
  Json results{{"small_gicp", measure_small_gicp_pair()}};
  if (words["--settings"] == "yes") results["settings"] = measure_settings();
  results["bunny"] = measure_bunny();
  save_results("pairs3d", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { pairs3d(Words(argc, argv, {{"--settings", "no"}})); });
}
