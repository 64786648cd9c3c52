// SPDX-License-Identifier: Apache-2.0
// reference DIR: the same scans for every language, and what the C++ library makes of them, bit by bit. Each file is
// doubles (.f64), floats (.f32) or 32-bit integers (.i32) one after the other, as they lie in memory.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace {

using namespace slamicp;

class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) { std::filesystem::create_directories(path_); }

  template <class T>
  void write(const std::string& name, const T* values, std::size_t count) const {
    std::ofstream file(path_ / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(T)));
    if (!file) throw Error("cannot be written", name);
  }
  template <class T>
  void write(const std::string& name, const std::vector<T>& values) const {
    write(name, values.data(), values.size());
  }
  template <int D>
  void write_points(const std::string& name, PointView<D> points) const {
    write(name, points.empty() ? nullptr : points.front().data(), points.size() * D);
  }

 private:
  std::filesystem::path path_;
};

void write_match(const Folder& folder, const std::string& name, const PointCloud2& map, const PointCloud2& scan,
                 const Pose2& guess, Method method) {
  const IcpResult2 result = align(scan, map, guess, {.method = method, .outlier_distance = 0.2, .max_iterations = 40});
  folder.write(name + "_pose.f64", std::vector<double>{result.pose.x, result.pose.y, result.pose.theta});
  folder.write(name + "_mean.f64", &result.mean_inlier_distance, 1);
  folder.write(name + "_iterations.i32", &result.iterations, 1);
  folder.write(name + "_outliers.i32", result.outlier_indices);
  folder.write_points<2>(name + "_outliers_in_map.f64", result.outliers_in_map);
  folder.write_points<2>(name + "_transformed.f64", result.transformed_scan);
}

/// A corner of a room, its floor and two walls, and the same seen from elsewhere.
void write_match_in_space(const Folder& folder) {
  PointCloud3 corner, seen;
  const Pose3 T_map_robot = Pose3::exp((Vector<6>() << 0.08, -0.05, 0.03, 0.02, -0.03, 0.04).finished());
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      for (const Point3& point :
           {Point3(0.1 * i, 0.1 * j, 0.0), Point3(0.1 * i, 0.0, 0.1 * j), Point3(0.0, 0.1 * i, 0.1 * j)}) {
        corner.push_back(point);
        if ((i + j) % 3 == 0) seen.push_back(T_map_robot.inverse() * point);
      }
  seen.push_back({1.5, 1.5, 1.5});  // what the map does not know
  const IcpResult3 result = align(seen, corner);
  const Matrix<3, 3> rotation = result.pose.rotation();
  std::vector<double> transform;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) transform.push_back(rotation(row, column));
    transform.push_back(result.pose.translation()[row]);
  }
  folder.write_points<3>("space_map.f64", corner);
  folder.write_points<3>("space_scan.f64", seen);
  folder.write("space_transform.f64", transform);
  folder.write("space_outliers.i32", result.outlier_indices);
}

void write_run(const Folder& folder, const World& world, const PointMap2::Pointer& map) {
  const SimulatedRun run = simulate_drive(world, route(world, "reference").waypoints, {.speed = 0.55, .seed = 4});
  constexpr std::size_t scans = 60, every = 8;
  Localizer localizer(map, {.max_correspondence_distance = 0.3, .outlier_distance = 0.1});
  localizer.set_pose(run.truth.front().pose);
  std::vector<float> ranges;
  std::vector<double> stamps, odometry, poses, boxes;
  std::vector<std::int32_t> counts, outliers;
  for (std::size_t k = 0; k < scans; ++k) {
    const LaserScan& scan = run.scans[k * every];
    const Fix& fix = localizer.update(scan);
    ranges.insert(ranges.end(), scan.ranges.begin(), scan.ranges.end());
    stamps.push_back(scan.stamp);
    for (const double value : {scan.T_odom_robot->x, scan.T_odom_robot->y, scan.T_odom_robot->theta})
      odometry.push_back(value);
    for (const double value : {fix.pose.x, fix.pose.y, fix.pose.theta}) poses.push_back(value);
    const auto obstacles = find_obstacles(fix, scan);
    counts.push_back(static_cast<std::int32_t>(fix.outliers().size()));
    counts.push_back(static_cast<std::int32_t>(obstacles.size()));
    outliers.insert(outliers.end(), fix.outliers().begin(), fix.outliers().end());
    for (const Obstacle& obstacle : obstacles)
      for (const double value : {obstacle.box.centre.x(), obstacle.box.centre.y(), obstacle.box.width})
        boxes.push_back(value);
  }
  const LaserScan& first = run.scans.front();
  folder.write("angles.f64",
               std::vector<double>{first.angle_min, first.angle_increment, first.range_min, first.range_max});
  const Pose2 start = run.truth.front().pose;
  folder.write("start.f64", std::vector<double>{start.x, start.y, start.theta});
  folder.write("ranges.f32", ranges);
  folder.write("stamps.f64", stamps);
  folder.write("odometry.f64", odometry);
  folder.write("poses.f64", poses);
  folder.write("counts.i32", counts);
  folder.write("outliers.i32", outliers);
  folder.write("boxes.f64", boxes);
}

}  // namespace

int main(int count, char** words) try {
  if (count != 2) throw Error("give the folder to write to", "reference");
  const Folder folder(words[1]);
  const World world = corridor_world_with("A2");
  Random random(7);
  const PointCloud2 map = sample_map(corridor_world(), random);
  folder.write_points<2>("map.f64", map);

  const Pose2 stood{9.0, 0.2, 0.3}, guess{9.06, 0.16, 0.33};
  const PointCloud2 scan = to_points(slamicp::scan(world, stood, hokuyo_utm30lx(), random)).in_robot;
  folder.write_points<2>("scan.f64", scan);
  folder.write("guess.f64", std::vector<double>{guess.x, guess.y, guess.theta});
  write_match(folder, "line", map, scan, guess, Method::point_to_line);
  write_match(folder, "point", map, scan, guess, Method::point_to_point);
  write_match_in_space(folder);
  write_run(folder, world, PointMap2::create(map));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
