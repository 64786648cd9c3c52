// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/held_out.hpp>
#include <slamicp/evaluation/stretch_trials.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/scan/scan_points.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp::held_out_test {
namespace {

/// A drive through the office, ten scans a second, mapped once for all tests.
const std::vector<PlacedRecord>& placed_drive() {
  static const std::vector<PlacedRecord> placed = [] {
    const World office = trial_world("office");
    DriveOptions options;
    options.speed = 0.5;
    options.lidar.rate = 10.0;
    SimulatedRun run = simulate_drive(office, route(office, "reference").waypoints, options);
    if (run.scans.size() > 400) run.scans.resize(400);
    return place_scans(run.scans);
  }();
  return placed;
}

TEST(HeldOut, PartsHaveNoScanInCommonAndShareAFrame) {
  const HeldOutLog parts = take_apart(placed_drive());
  ASSERT_EQ(parts.run.size(), placed_drive().size() / 2);
  for (std::size_t k = 0; k < parts.run.size(); ++k) EXPECT_EQ(parts.run[k], &placed_drive()[2 * k + 1]);
  // Two readings of the same walls.
  std::size_t near = 0;
  for (const Point2& point : parts.map->points()) near += parts.other_map->indexed().nearest(point, 0.1).found();
  EXPECT_GT(near, 9 * parts.map->size() / 10);
}

TEST(HeldOut, AMapTakesWhatIsNewAndSeenTwice) {
  std::vector<const PlacedRecord*> scans;
  for (std::size_t k = 0; k < 40; ++k) scans.push_back(&placed_drive()[k]);
  const PointMap2::Pointer fine = map_of(scans), coarse = map_of(scans, 0.2);
  EXPECT_GT(fine->size(), 100U);
  EXPECT_LT(coarse->size(), fine->size());
  EXPECT_THROW(map_of({}), Error);
  // What a single scan shows nobody has seen twice.
  EXPECT_THROW(map_of(std::span(scans).first(1)), Error);
}

TEST(HeldOut, HalvesOfAScanHoldEachReturnOnce) {
  const LaserScan& scan = placed_drive().front().scan;
  const PointCloud2 all = to_points(scan).in_robot;
  const PointCloud2 even = to_points(half_of_beams(scan, 0)).in_robot;
  const PointCloud2 odd = to_points(half_of_beams(scan, 1)).in_robot;
  ASSERT_EQ(all.size(), scan.ranges.size());
  ASSERT_EQ(even.size() + odd.size(), all.size());
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_LT((all[k] - (k % 2 == 0 ? even : odd)[k / 2]).norm(), 1e-6) << k;
}

TEST(HeldOut, CovariancesOfASimulatedDriveAreAboutRight) {
  const HeldOutPairs pairs = compare(take_apart(placed_drive()));
  ASSERT_EQ(pairs.matches.size(), pairs.fixes.size());
  ASSERT_GT(pairs.matches.size(), 30U);
  EXPECT_EQ(pairs.lost_tracks, 0);
  double nees = 0.0;
  std::size_t counted = 0;
  for (const IndependentPair& pair : pairs.matches) {
    if (!pair.usable || pair.blind || pair.difference.head<2>().norm() > 0.1) continue;
    nees += pair.nees() / 3.0;
    ++counted;
  }
  EXPECT_GE(counted, pairs.matches.size() - 3);
  nees /= static_cast<double>(counted);
  EXPECT_GT(nees, 0.3);
  EXPECT_LT(nees, 3.0);
}

ReferenceRun reference_run() {
  ReferenceRun run;
  run.map = take_apart(placed_drive()).map;
  for (const PlacedRecord& record : placed_drive()) {
    run.scans.push_back(record.scan);
    run.reference.push_back(record.pose);
  }
  return run;
}

TEST(StretchTrialsTest, RightPlacesAreTrustedAndWrongOnesNoticed) {
  const ReferenceRun run = reference_run();
  StretchTrials trials(run, 3);
  int fixes = 0;
  trials.watch([&](const Fix&, const Pose2&) { ++fixes; });
  int noticed = 0;
  for (int k = 0; k < 5; ++k) {
    const StretchOutcome here = trials.draw(false);
    EXPECT_EQ(here.right_scans, 80);
    EXPECT_EQ(here.alarms, 0);
    EXPECT_EQ(here.longest_confident, 0.0);
    noticed += trials.draw(true).noticed;
  }
  EXPECT_EQ(fixes, 800);
  EXPECT_GE(noticed, 4);
}

TEST(StretchTrialsTest, NeedsAReferenceForEachScan) {
  ReferenceRun run = reference_run();
  run.reference.pop_back();
  EXPECT_THROW(StretchTrials(run, 1), Error);
}

}  // namespace
}  // namespace slamicp::held_out_test
