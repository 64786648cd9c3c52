// SPDX-License-Identifier: Apache-2.0
// What one machine makes of a drive through the corridor, another one makes of it too: the scalar path within 1e-9 m
// and rad, the vectorized ones within 1e-5, and outliers that differ only where a point is within 1e-5 m of the
// threshold.
// (The two paths see the map's lines differently: on one machine they are up to 0.1 mm apart.)
//   same_answers write DIR   drives, matches every scan with every instruction set of this machine, and writes it down
//   same_answers check DIR   does the same with the scans in DIR, and compares; 1 where they differ
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/scan/scan_points.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace {

using namespace slamicp;
namespace fs = std::filesystem;

constexpr double outlier_distance = 0.1;    // [m]
constexpr double scalar_tolerance = 1e-9;   // [m], [rad]
constexpr double vector_tolerance = 1e-5;   // [m], [rad]
constexpr double outlier_tolerance = 1e-5;  // [m]

constexpr InstructionSet all_sets[] = {InstructionSet::scalar, InstructionSet::portable, InstructionSet::sse4,
                                       InstructionSet::avx2,   InstructionSet::avx512,   InstructionSet::neon};

/// Numbers one after the other, as they lie in memory: all machines here have the lowest byte first.
template <class T>
void write_numbers(const fs::path& file, const std::vector<T>& numbers) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(T)));
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

template <class T>
std::vector<T> read_numbers(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("there is no " + file.string() + ": run `same_answers write` on another machine");
  std::vector<T> numbers(static_cast<std::size_t>(fs::file_size(file) / sizeof(T)));
  in.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(T)));
  return numbers;
}

PointCloud2 points_of(const std::vector<double>& numbers) {
  PointCloud2 points;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) points.emplace_back(numbers[k], numbers[k + 1]);
  return points;
}

/// What is matched: a map, scans, and where the robot thought it was at each.
struct Drive {
  PointCloud2 map;
  std::vector<LaserScan> scans;
  std::vector<Pose2> guesses;
};

Drive drive() {
  constexpr std::size_t every = 16;
  const World world = corridor_world_with("A2");
  const SimulatedRun run = simulate_drive(world, route(world, "reference").waypoints, {.speed = 0.55, .seed = 20});
  Random random(7);
  Drive all{sample_map(corridor_world(), random), {}, {}};
  for (std::size_t k = 0; k < run.scans.size(); k += every) {
    const Pose2 off{random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), random.uniform(-0.05, 0.05)};
    all.scans.push_back(run.scans[k]);
    all.guesses.push_back(run.truth[k].pose * off);
  }
  return all;
}

void write_drive(const fs::path& folder, const Drive& all) {
  std::vector<double> map, guesses, odometry;
  std::vector<float> ranges;
  for (const Point2& point : all.map) map.insert(map.end(), {point.x(), point.y()});
  for (const Pose2& guess : all.guesses) guesses.insert(guesses.end(), {guess.x, guess.y, guess.theta});
  for (const LaserScan& scan : all.scans) {
    ranges.insert(ranges.end(), scan.ranges.begin(), scan.ranges.end());
    odometry.insert(odometry.end(), {scan.stamp, scan.T_odom_robot->x, scan.T_odom_robot->y, scan.T_odom_robot->theta});
  }
  const LaserScan& first = all.scans.front();
  write_numbers(folder / "map.f64", map);
  write_numbers(folder / "guesses.f64", guesses);
  write_numbers(folder / "odometry.f64", odometry);
  write_numbers(folder / "ranges.f32", ranges);
  write_numbers(folder / "angles.f64",
                std::vector<double>{first.angle_min, first.angle_increment, static_cast<double>(first.range_min),
                                    static_cast<double>(first.range_max)});
}

Drive read_drive(const fs::path& folder) {
  const auto guesses = read_numbers<double>(folder / "guesses.f64");
  const auto odometry = read_numbers<double>(folder / "odometry.f64");
  const auto ranges = read_numbers<float>(folder / "ranges.f32");
  const auto angles = read_numbers<double>(folder / "angles.f64");
  const std::size_t count = guesses.size() / 3;
  const std::size_t beams = ranges.size() / count;
  Drive all{points_of(read_numbers<double>(folder / "map.f64")), {}, {}};
  for (std::size_t k = 0; k < count; ++k) {
    LaserScan scan;
    scan.angle_min = angles[0];
    scan.angle_increment = angles[1];
    scan.range_min = static_cast<decltype(scan.range_min)>(angles[2]);
    scan.range_max = static_cast<decltype(scan.range_max)>(angles[3]);
    const auto begin = ranges.begin() + static_cast<std::ptrdiff_t>(k * beams);
    scan.ranges.assign(begin, begin + static_cast<std::ptrdiff_t>(beams));
    scan.stamp = odometry[4 * k];
    scan.T_odom_robot = Pose2{odometry[4 * k + 1], odometry[4 * k + 2], odometry[4 * k + 3]};
    all.scans.push_back(scan);
    all.guesses.push_back({guesses[3 * k], guesses[3 * k + 1], guesses[3 * k + 2]});
  }
  return all;
}

/// One instruction set's answers to a drive, as they are written down.
struct Answers {
  std::vector<double> poses;         ///< x, y, theta a scan
  std::vector<std::int32_t> counts;  ///< points a scan
  std::vector<double> distances;     ///< of every point to the map; NaN where it is farther than anybody asked
  std::vector<std::int32_t> is_out;  ///< 1 where the point is an outlier
};

void add(Answers& answers, const IcpResult2& result) {
  answers.poses.insert(answers.poses.end(), {result.pose.x, result.pose.y, result.pose.theta});
  answers.counts.push_back(static_cast<std::int32_t>(result.matches.size()));
  for (const Match& match : result.matches) {
    answers.distances.push_back(match.distance);
    answers.is_out.push_back(is_outlier(match.point_class) ? 1 : 0);
  }
}

Answers answers_of(const Drive& all, const IndexedPoints<2>& map, InstructionSet set) {
  Answers answers;
  Icp<2> icp({.outlier_distance = outlier_distance, .instruction_set = set});
  for (std::size_t k = 0; k < all.scans.size(); ++k)
    add(answers,
        icp.align(map, to_points(all.scans[k]).in_robot, all.guesses[k], {.outlier_indices = true, .matches = true}));
  return answers;
}

/// One fix after the other, each predicted from those before by odometry: what a robot does.
Answers fixes_of(const Drive& all, const PointMap2::Pointer& map) {
  Answers answers;
  LocalizerOptions options;
  options.outlier_distance = outlier_distance;
  options.outputs.matches = true;
  Localizer localizer(map, options);
  localizer.set_pose(all.guesses.front());
  for (const LaserScan& scan : all.scans) add(answers, localizer.update(scan).match);
  return answers;
}

void write_answers(const fs::path& folder, const std::string& name, const Answers& answers) {
  write_numbers(folder / (name + "_poses.f64"), answers.poses);
  write_numbers(folder / (name + "_counts.i32"), answers.counts);
  write_numbers(folder / (name + "_distances.f64"), answers.distances);
  write_numbers(folder / (name + "_outliers.i32"), answers.is_out);
}

Answers read_answers(const fs::path& folder, const std::string& name) {
  return {read_numbers<double>(folder / (name + "_poses.f64")),
          read_numbers<std::int32_t>(folder / (name + "_counts.i32")),
          read_numbers<double>(folder / (name + "_distances.f64")),
          read_numbers<std::int32_t>(folder / (name + "_outliers.i32"))};
}

/// How far two answers are apart.
struct Difference {
  double pose = 0.0;          ///< the largest [m], [rad]
  std::size_t outliers = 0;   ///< points that are outliers of one alone
  double from_threshold = 0;  ///< how far such a point was from the threshold at most, in either [m]
};

Difference difference_of(const Answers& here, const Answers& there) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (here.counts != there.counts || here.poses.size() != there.poses.size()) return {infinity, 0, infinity};
  Difference difference;
  for (std::size_t k = 0; k < here.poses.size(); ++k)
    difference.pose = std::max(difference.pose, std::abs(here.poses[k] - there.poses[k]));
  for (std::size_t k = 0; k < here.is_out.size(); ++k) {
    if (here.is_out[k] == there.is_out[k]) continue;
    ++difference.outliers;
    for (const double distance : {here.distances[k], there.distances[k]})
      difference.from_threshold = std::max(difference.from_threshold, std::abs(distance - outlier_distance));
  }
  return difference;
}

bool report(const std::string& here, const std::string& there, const Difference& difference, double tolerance) {
  const bool good = difference.pose <= tolerance && difference.from_threshold <= outlier_tolerance;
  std::printf(
      "%-16s and the other's %-10s poses differ by %8.2g at most, outliers by %zu, %.2g m from the threshold%s\n",
      here.c_str(), there.c_str(), difference.pose, difference.outliers, difference.from_threshold,
      good ? "" : "   TOO MUCH");
  return good;
}

void write(const fs::path& folder) {
  fs::create_directories(folder);
  const Drive all = drive();
  const auto map = PointMap2::create(all.map);
  write_drive(folder, all);
  for (const InstructionSet set : all_sets)
    if (is_available(set)) write_answers(folder, to_string(set), answers_of(all, map->indexed(), set));
  write_answers(folder, "localizer", fixes_of(all, map));
}

bool check(const fs::path& folder) {
  const Drive all = read_drive(folder);
  const auto map = PointMap2::create(all.map);
  std::printf("%zu scans, %zu map points; this machine's best: %s\n", all.scans.size(), all.map.size(),
              to_string(best_instruction_set()));
  bool good = true;
  for (const InstructionSet set : all_sets) {
    if (!is_available(set)) continue;
    const Answers here = answers_of(all, map->indexed(), set);
    for (const InstructionSet other : all_sets) {
      const bool scalar = set == InstructionSet::scalar;
      if (scalar != (other == InstructionSet::scalar)) continue;  // see instruction_set_property_test.cpp
      if (!fs::exists(folder / (std::string(to_string(other)) + "_poses.f64"))) continue;
      good &= report(to_string(set), to_string(other), difference_of(here, read_answers(folder, to_string(other))),
                     scalar ? scalar_tolerance : vector_tolerance);
    }
  }
  good &= report("localizer", "localizer", difference_of(fixes_of(all, map), read_answers(folder, "localizer")),
                 vector_tolerance);
  return good;
}

}  // namespace

int main(int count, char** words) try {
  const std::string verb = count == 3 ? words[1] : "";
  if (verb == "write") return write(words[2]), 0;
  if (verb == "check") return check(words[2]) ? 0 : 1;
  std::puts("same_answers write|check DIR");
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
