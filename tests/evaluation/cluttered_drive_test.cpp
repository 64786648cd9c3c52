// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/cluttered_drive.hpp>
#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/localization/localizer.hpp>

namespace slamicp::cluttered_drive_test {
namespace {

TEST(ClutteredDriveTest, NobodyIsLostOrDoubtedAmongThingsThatTheMapDoesNotKnow) {
  constexpr int scans = 160;
  for (const std::string_view world : trial_world_names())
    for (const bool moving : {false, true}) {
      SCOPED_TRACE(std::string(world) + (moving ? ", walking" : ""));
      ClutteredDrive drive(world, 4, {.unmapped = 0.4, .moving = moving});
      Localizer localizer(drive.map());
      localizer.set_pose(drive.truth());
      std::vector<double> off;
      int doubted = 0;
      for (int k = 0; k < scans; ++k) {
        const Fix& fix = localizer.update(drive.next());
        off.push_back(distance(fix.pose, drive.truth()).translation);
        doubted += fix.quality.doubted();
      }
      std::sort(off.begin(), off.end());
      EXPECT_LT(off[scans * 95 / 100], 0.02);
      EXPECT_LT(off.back(), 0.1);
      EXPECT_EQ(doubted, 0);
    }
}

TEST(ClutteredDriveTest, HidesWhatWasAskedForAndKeepsOffTheWay) {
  ClutteredDrive bare("hall", 2, {.unmapped = 0.0}), full("hall", 2, {.unmapped = 0.4});
  const LaserScan& alone = bare.next();
  const LaserScan& among = full.next();
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < alone.ranges.size(); ++i) hidden += among.ranges[i] < alone.ranges[i] - 0.1F;
  EXPECT_GT(hidden, alone.ranges.size() / 4);
  for (int k = 0; k < 40; ++k) {
    const LaserScan& seen = full.next();
    EXPECT_GT(*std::min_element(seen.ranges.begin(), seen.ranges.end()), 0.3F);
  }
}

TEST(ClutteredDriveTest, TheSameSeedGivesTheSameScans) {
  ClutteredDrive once("hall", 7, {.moving = true}), again("hall", 7, {.moving = true});
  for (int k = 0; k < 50; ++k) ASSERT_EQ(once.next().ranges, again.next().ranges);
  EXPECT_EQ(once.truth().x, again.truth().x);
}

TEST(ClutteredDriveTest, NamesWhatIsWrong) {
  EXPECT_EQ(ClutteredDriveOptions{}.problem(), "");
  EXPECT_THROW(ClutteredDrive("office", 1, {.unmapped = 0.9}), Error);
  EXPECT_THROW(ClutteredDrive("office", 1, {.speed = 0.0}), Error);
  EXPECT_THROW(ClutteredDrive("nowhere", 1), Error);
}

}  // namespace
}  // namespace slamicp::cluttered_drive_test
