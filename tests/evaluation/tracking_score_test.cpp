// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/evaluation/tracking_score.hpp>

namespace slamicp::tracking_score_test {
namespace {

TrackedTruth truth(int id, double x, bool counts = true) { return {id, {x, 0.0}, {1.0, 0.0}, counts}; }
TrackedGuess guess(int id, double x) { return {id, {x, 0.0}, {1.0, 0.3}}; }

TEST(TrackingScore, CountsWhatWasFoundMissedFalseAndMistaken) {
  TrackingScore score(0.5);
  const TrackedTruth two[] = {truth(1, 0.0), truth(2, 5.0)};
  const TrackedGuess both[] = {guess(10, 0.1), guess(20, 5.0)};
  score.add(two, both);
  const TrackedGuess one_and_a_ghost[] = {guess(10, 0.3), guess(30, 9.0)};
  score.add(two, one_and_a_ghost);
  const TrackedGuess other_ids[] = {guess(10, 5.0), guess(20, 0.0)};
  score.add(two, other_ids);
  EXPECT_EQ(score.frames(), 3U);
  EXPECT_EQ(score.truths(), 6U);
  EXPECT_EQ(score.found(), 5U);
  EXPECT_EQ(score.missed(), 1U);
  EXPECT_EQ(score.false_ones(), 1U);
  EXPECT_EQ(score.switches(), 2U);
  EXPECT_DOUBLE_EQ(score.mota(), 1.0 - 4.0 / 6.0);
  EXPECT_NEAR(score.motp(), 0.4 / 5.0, 1e-12);
  EXPECT_NEAR(score.velocity_rmse(), 0.3, 1e-12);
}

TEST(TrackingScore, APairStaysAPairAsLongAsItIsNearEnough) {
  TrackingScore score(0.5);
  const TrackedTruth one[] = {truth(1, 0.0)};
  const TrackedGuess first[] = {guess(10, 0.0)};
  score.add(one, first);
  const TrackedGuess two[] = {guess(20, 0.0), guess(10, 0.4)};  // a nearer one comes by
  score.add(one, two);
  EXPECT_EQ(score.switches(), 0U);
  EXPECT_EQ(score.false_ones(), 1U);
}

TEST(TrackingScore, WhoIsHardlyToBeSeenCountsNeitherWay) {
  TrackingScore score(0.5);
  const TrackedTruth hidden[] = {truth(1, 0.0, false)};
  const TrackedGuess found[] = {guess(10, 0.0)};
  score.add(hidden, found);
  score.add(hidden, {});
  EXPECT_EQ(score.truths(), 0U);
  EXPECT_EQ(score.false_ones(), 0U);
  EXPECT_EQ(score.mota(), 1.0);
  score.next_run();
  const TrackedTruth seen[] = {truth(1, 0.0)};
  const TrackedGuess another[] = {guess(20, 0.0)};
  score.add(seen, another);
  EXPECT_EQ(score.switches(), 0U) << "another run: another id is no switch";
}

}  // namespace
}  // namespace slamicp::tracking_score_test
