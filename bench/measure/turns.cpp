// SPDX-License-Identifier: Apache-2.0
// Turns while the laser sweeps: errors and false outliers with and without de-skewing, beside a robot at rest
//
// scripts/measure turns [--turn RAD_PER_S] [--sweep S]
//
// The simulated UTM-30LX in the corridor world and in a hall of 24 m x 16 m, whose walls are far, so that a turn moves
// points a long way. Twelve places each, 60 scans at 40 Hz from each, of which the first ten do not count.
#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

constexpr double rate = 40.0;
constexpr int settled = 10;
constexpr int scans = 60;

World hall() {
  World world;
  world.name = "hall";
  for (const Segment& side : sides({{0.0, 0.0}, 24.0, 16.0, 0.0})) world.walls.push_back(side);
  for (const Point2& pillar : {Point2(-6.0, -3.0), Point2(6.0, -3.0), Point2(-6.0, 3.5), Point2(6.0, 3.5)})
    world.pillars.push_back({pillar, 0.4});
  world.routes.push_back({"reference", {{-10.0, -6.0}, {-3.0, 0.0}, {0.0, 5.0}, {9.0, 6.0}}});
  return world;
}

enum class Told { nothing, by_fixes, by_wheels };

struct Errors {
  std::vector<double> millimetres, degrees, outliers;
};

/// Scans of a robot with constant velocity, from a place on.
void follow(const World& world, const PointMap2::Pointer& map, const LidarModel& lidar, const Pose2& start,
            const Vector<3>& velocity, Told told, std::uint64_t seed, Errors& errors) {
  Localizer localizer(map, {.deskew = told != Told::nothing});
  localizer.set_pose(start);
  Random random(seed);
  for (int k = 0; k < scans; ++k) {
    const double stamp = k / rate;
    const Pose2 truth = start * Pose2::exp(stamp * velocity);
    const Pose2 sweep = Pose2::exp(lidar.sweep_time * velocity);
    LaserScan seen = scan(world, truth, sweep, lidar, random);
    seen.stamp = stamp;
    if (told == Told::by_wheels) {
      seen.T_odom_robot = truth;
      seen.sweep_motion = sweep;
    }
    const Fix& fix = localizer.update(seen);
    if (k < settled) continue;
    const PoseDistance off = distance(fix.pose, truth);
    errors.millimetres.push_back(1e3 * off.translation);
    errors.degrees.push_back(deg_per_rad * off.rotation);
    errors.outliers.push_back(static_cast<double>(fix.outliers().size()));
  }
}

struct Row {
  const char* motion;
  const char* deskew;
  double metres_per_second;
  double turns;  // of the turn asked for
  Told told;
};
constexpr Row rows[] = {
    {"at rest", "-", 0.0, 0.0, Told::by_fixes},
    {"turning", "no", 0.0, 1.0, Told::nothing},
    {"turning", "by fixes", 0.0, 1.0, Told::by_fixes},
    {"turning", "by wheels", 0.0, 1.0, Told::by_wheels},
    {"driving and turning", "no", 0.5, 1.0, Told::nothing},
    {"driving and turning", "by fixes", 0.5, 1.0, Told::by_fixes},
    {"driving and turning", "by wheels", 0.5, 1.0, Told::by_wheels},
};

void measure(const World& world, double turn, const LidarModel& lidar, Table& table, Json& results) {
  Random random(1);
  const PointMap2::Pointer map = PointMap2::create(sample_map(world, random));
  const std::vector<Point2>& places = route(world, "reference").waypoints;
  for (const Row& row : rows) {
    Errors errors;
    for (std::uint64_t k = 0; k < 12; ++k) {
      const Point2& place = places[k % places.size()];
      const Pose2 start{place.x(), place.y(), 0.5 * static_cast<double>(k) - 3.0};
      follow(world, map, lidar, start, {row.metres_per_second, 0.0, row.turns * turn}, row.told, k + 2, errors);
    }
    const double p95 = quantile(errors.millimetres, 0.95);
    const double outliers = mean(errors.outliers);
    table.add({world.name, row.motion, row.deskew, text("%.1f / %.1f", mean(errors.millimetres), p95),
               text("%.3f / %.3f", mean(errors.degrees), quantile(errors.degrees, 0.95)), text("%.2f", outliers),
               text("%.2f %%", 100.0 * outliers / lidar.beams)});
    results.push_back({{"world", world.name},
                       {"motion", row.motion},
                       {"deskew", row.deskew},
                       {"error_mm", {{"mean", mean(errors.millimetres)}, {"p95", p95}}},
                       {"outliers", outliers}});
  }
}

void turns(const Words& words) {
  LidarModel lidar = hokuyo_utm30lx();
  lidar.sweep_time = std::stod(words["--sweep"]);
  const double turn = std::stod(words["--turn"]);
  Table table(
      {"world", "motion", "de-skewed", "error mm mean / p95", "deg mean / p95", "outliers a scan", "of the beams"});
  Json results = Json::array();
  measure(corridor_world(), turn, lidar, table, results);
  measure(hall(), turn, lidar, table, results);
  std::printf("%.1f rad/s, a sweep in %.0f ms, nothing unmapped: every outlier is false.\n\n", turn,
              1e3 * lidar.sweep_time);
  table.print();
  save_results("turns", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { turns(Words(argc, argv, {{"--turn", "2.0"}, {"--sweep", "0.025"}})); });
}
