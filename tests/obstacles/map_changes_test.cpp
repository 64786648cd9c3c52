// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/map_changes.hpp>

#include "support/room.hpp"

namespace slamicp::map_changes_test {
namespace {

/// A drive of 8 s through the simple room, in a map of `mapped`, with what `standing` says at each moment.
template <typename Standing>
std::vector<ProposedChange> drive(const test::Room& mapped, const Standing& standing) {
  test::Random random(1);
  Localizer localizer(PointMap2::create(mapped.map(0.01)));
  MapChanges changes({.interval = 0.1});
  ObstacleFinder finder;
  for (int k = 0; k < 80; ++k) {
    const double stamp = 0.1 * k;
    const Pose2 pose{1.2 + 0.02 * k, 1.2 + 0.002 * k, 0.3 + 0.004 * k};
    if (k == 0) localizer.set_pose(pose);
    const LaserScan scan = standing(stamp).scan(pose, stamp, 0.01, &random);
    const Fix& fix = localizer.update(scan);
    changes.add(fix, scan, finder.find(fix, scan));
  }
  return changes.proposals();
}

test::Room with_shelf(test::Room room, const Point2& place) {
  room.add_box(place, 0.6, 0.3, 0.1);
  return room;
}

TEST(MapChangesTest, AShelfThatWasMovedIsProposedAtBothEndsAndNothingElse) {
  const test::Room room = test::simple_room();
  const Point2 before(4.9, 1.0), now(3.2, 2.6);
  const test::Room as_it_is = with_shelf(room, now);
  const std::vector<ProposedChange> changes = drive(with_shelf(room, before), [&](double) { return as_it_is; });
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].kind, ProposedChange::Kind::add);
  EXPECT_LT((changes[0].box.centre - now).norm(), 0.25);
  EXPECT_GT(changes[0].box.width, 0.4);
  EXPECT_TRUE(changes[0].map_index.empty());
  EXPECT_EQ(changes[1].kind, ProposedChange::Kind::remove);
  EXPECT_LT((changes[1].box.centre - before).norm(), 0.25);
  EXPECT_GT(changes[1].map_index.size(), 30U);
  EXPECT_EQ(changes[1].map_index.size(), changes[1].points.size());
  for (const ProposedChange& change : changes) {
    EXPECT_GE(change.share, 0.8);
    EXPECT_GE(change.scans, 8);
    EXPECT_GE(change.baseline, 0.5);
    EXPECT_GE(change.last_stamp - change.first_stamp, 3.0);
    EXPECT_NE(change.brief().find("agree"), std::string::npos);
  }
}

TEST(MapChangesTest, WithoutChangesNothingIsProposed) {
  const test::Room room = test::simple_room();
  EXPECT_TRUE(drive(room, [&](double) { return room; }).empty());
}

TEST(MapChangesTest, WhoWalksOrLeavesIsNotProposed) {
  const test::Room room = test::simple_room();
  const auto walking = [&](double stamp) {
    test::Room with_people = room;
    with_people.add_box({2.5 + 0.3 * stamp, 3.0 - 0.25 * stamp}, 0.3, 0.3, 0.2);
    if (stamp < 3.5) with_people.add_box({3.0, 0.6}, 0.3, 0.3, 0.2);  // stands for a while, then is gone
    return with_people;
  };
  EXPECT_TRUE(drive(room, walking).empty());
}

TEST(MapChangesTest, AScanOfADoubtedPoseCountsForNothing) {
  const test::Room room = test::simple_room();
  const test::Room changed = with_shelf(room, {3.2, 2.6});
  Localizer localizer(PointMap2::create(room.map(0.01)));
  const Pose2 pose{1.5, 1.2, 0.4};
  localizer.set_pose(pose);
  const LaserScan scan = changed.scan(pose);
  Fix fix = localizer.update(scan);
  fix.quality.state = TrackingState::suspect;
  MapChanges changes({.interval = 0.0, .min_scans = 1, .min_seconds = 0.0, .min_baseline = 0.0});
  changes.add(fix, scan, find_obstacles(fix, scan));
  EXPECT_TRUE(changes.proposals().empty());
  fix.quality.state = TrackingState::tracking;
  changes.add(fix, scan, find_obstacles(fix, scan));
  EXPECT_EQ(changes.proposals().size(), 1U);
}

TEST(MapChangesTest, AbsurdOptionsAreRefused) {
  const MapChangeOptions absurd[] = {{.cell = 0.0},         {.interval = -1.0},          {.min_scans = 0},
                                     {.min_seconds = -1.0}, {.min_baseline = test::nan}, {.min_share = 0.5},
                                     {.min_share = 1.1},    {.min_size = -0.1}};
  for (const MapChangeOptions& options : absurd) {
    EXPECT_FALSE(options.problem().empty());
    EXPECT_THROW(MapChanges changes(options), Error);
  }
}

}  // namespace
}  // namespace slamicp::map_changes_test
