// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>

#include "localization/judge.hpp"
#include "support/room.hpp"

namespace slamicp::quality_test {
namespace {

using test::Room;

struct Scene {
  Room room = test::simple_room();
  PointMap2::Pointer map = PointMap2::create(room.map(0.01));
  Pose2 truth{1.5, 1.2, 0.4};

  Evidence seen_from(const Pose2& thought) const {
    const ScanPoints points = to_points(room.scan(truth, 0.0));
    const Point2 origin = Point2::Zero();
    return look(map->indexed(), {points, {&origin, 1}, thought}, 64, 0.3, 0.01);
  }
};

TEST(EvidenceTest, IsAllForTheRightPose) {
  const Scene scene;
  const Evidence evidence = scene.seen_from(scene.truth);
  EXPECT_EQ(evidence.rays, 64);
  EXPECT_GE(evidence.explained, 0.97);
  EXPECT_LE(evidence.violations, 0.02);
  EXPECT_GT(log_odds(evidence), 2.0);
}

TEST(EvidenceTest, SpeaksAgainstAWrongPose) {
  const Scene scene;
  EXPECT_LT(log_odds(scene.seen_from(scene.truth * Pose2{0.8, 0.3, 0.0})), -2.0);
  EXPECT_LT(log_odds(scene.seen_from(scene.truth * Pose2{0.0, 0.0, 1.0})), -2.0);
}

TEST(EvidenceTest, IsNothingWithoutPoints) {
  const Scene scene;
  const Point2 origin = Point2::Zero();
  const ScanPoints none;
  EXPECT_EQ(look(scene.map->indexed(), {none, {&origin, 1}, {}}, 64, 0.3, 0.01).rays, 0);
}

Evidence good() { return {64, 0.95, 0.03, 0.0, 1.0}; }
Evidence bad() { return {64, 0.3, 0.4, 0.2, 0.2}; }

TEST(JudgeTest, DoubtsOnlyWhenScansSpeakAgainstThePoseForAWhile) {
  Judge judge({});
  for (int k = 0; k < 50; ++k) EXPECT_EQ(judge.update(good(), true, true, 0.0).state, TrackingState::tracking);
  EXPECT_EQ(judge.update(bad(), true, true, 0.0).state, TrackingState::tracking) << "one scan is not enough";
  int until = 1;
  while (judge.update(bad(), true, true, 0.0).state == TrackingState::tracking) ++until;
  EXPECT_LE(until, 15);
}

TEST(JudgeTest, IsLostAfterAWhileAndComesBackSlowly) {
  const QualityOptions options;
  Judge judge(options);
  Quality quality;
  for (int k = 0; k < 40; ++k) quality = judge.update(bad(), true, true, 0.0);
  EXPECT_EQ(quality.state, TrackingState::lost);
  EXPECT_LT(quality.probability, 0.05);
  EXPECT_EQ(judge.update(good(), true, true, 0.0).state, TrackingState::lost) << "hysteresis";
  for (int k = 0; k < 100; ++k) quality = judge.update(good(), true, true, 0.0);
  EXPECT_EQ(quality.state, TrackingState::tracking);
  EXPECT_GT(quality.probability, options.trusted_above);
}

TEST(JudgeTest, ABlindDirectionIsDegenerateAndNoMatchIsDoubted) {
  Judge judge({});
  EXPECT_EQ(judge.update(good(), true, false, 0.0).state, TrackingState::degenerate);
  Quality quality;
  for (int k = 0; k < 40; ++k) quality = judge.update({}, false, true, 0.0);
  EXPECT_EQ(quality.state, TrackingState::lost);
}

TEST(JudgeTest, APoseFollowedForLongIsDoubtedLaterUnlessItSurprised) {
  const auto doubted_after = [](int good_scans, double surprise) {
    Judge judge({});
    for (int k = 0; k < good_scans; ++k) judge.update(good(), true, true, 0.0);
    int scans = 1;
    while (!judge.update(bad(), true, true, scans == 1 ? surprise : 0.0).doubted()) ++scans;
    return scans;
  };
  EXPECT_GT(doubted_after(1000, 0.0), doubted_after(40, 0.0));
  EXPECT_EQ(doubted_after(1000, 1.0), doubted_after(40, 1.0));
  EXPECT_GT(doubted_after(1000, 0.3), doubted_after(1000, 1.0)) << "a small surprise costs little";
  EXPECT_LT(doubted_after(1000, 0.0), 40) << "within a second all the same";
}

TEST(QualityOptionsTest, NamesWhatIsWrong) {
  EXPECT_EQ(QualityOptions{}.problem(), "");
  EXPECT_EQ(QualityOptions{.rays = 0}.problem(), "");
  EXPECT_NE(QualityOptions{.rays = 5}.problem(), "");
  EXPECT_NE(QualityOptions{.suspect_below = 0.97}.problem(), "");
  EXPECT_NE(QualityOptions{.memory = 0.0}.problem(), "");
  const Scene scene;
  EXPECT_THROW(Localizer(scene.map, {.quality = {.lost_after = 0}}), Error);
}

TEST(LocalizerQualityTest, ALocalizerKnowsThatItIsElsewhereAndFindsItselfAgain) {
  const Scene scene;
  Localizer localizer(scene.map);
  localizer.set_pose(scene.truth * Pose2{1.4, 0.5, 1.6});
  Quality quality;
  for (int k = 0; k < 60; ++k) quality = localizer.update(scene.room.scan(scene.truth, 0.025 * k)).quality;
  ASSERT_GT(distance(localizer.fix().pose, scene.truth).translation, 0.3) << "the match found it by itself";
  EXPECT_EQ(quality.state, TrackingState::lost);
  int calls = 0;
  while (!localizer.recover(1000) && calls < 400) ++calls;
  EXPECT_LT(calls, 400);
  const Fix& fix = localizer.update(scene.room.scan(scene.truth, 2.0));
  EXPECT_LT(distance(fix.pose, scene.truth).translation, 0.01);
  EXPECT_EQ(fix.quality.state, TrackingState::tracking);
}

TEST(LocalizerQualityTest, NothingIsLookedForWhereAllIsWell) {
  const Scene scene;
  Localizer localizer(scene.map);
  localizer.set_pose(scene.truth);
  EXPECT_FALSE(localizer.recover(1000)) << "no scan yet";
  for (int k = 0; k < 5; ++k) localizer.update(scene.room.scan(scene.truth, 0.025 * k));
  EXPECT_EQ(localizer.fix().quality.state, TrackingState::tracking);
  EXPECT_FALSE(localizer.recover(1000000));
}

TEST(LocalSearchTest, FindsTheRobotInStepsOfAnySize) {
  const Scene scene;
  for (const int budget : {1, 777, 1000000}) {
    LocalSearch search(scene.map, to_points(scene.room.scan(scene.truth, 0.0)), Point2::Zero(),
                       scene.truth * Pose2{0.7, -0.5, 2.0});
    EXPECT_FALSE(search.found().has_value());
    while (!search.step(budget)) {
    }
    const std::optional<FoundPlace> found = search.found();
    ASSERT_TRUE(found.has_value());
    EXPECT_LT(distance(found->pose, scene.truth).translation, 0.01);
    EXPECT_TRUE(found->unique);
    EXPECT_GT(found->probability, 0.9);
  }
}

TEST(LocalSearchTest, NamesWhatIsWrong) {
  EXPECT_EQ(LocalSearchOptions{}.problem(), "");
  EXPECT_NE(LocalSearchOptions{.radius = 0.0}.problem(), "");
  EXPECT_NE(LocalSearchOptions{.heading_step = 0.0}.problem(), "");
  EXPECT_NE(LocalSearchOptions{.points = 1}.problem(), "");
  EXPECT_THROW(LocalSearch(nullptr, {}, Point2::Zero(), {}), Error);
}

}  // namespace
}  // namespace slamicp::quality_test
