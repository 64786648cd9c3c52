// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/false_alarms.hpp>

namespace slamicp::false_alarms_test {
namespace {

/// A cycle that sees obstacles there.
void see(FalseAlarms& alarms, std::initializer_list<Point2> places, Decision decision = Decision::ignore) {
  std::vector<EvaluatedObstacle> obstacles;
  for (const Point2& place : places) {
    obstacles.emplace_back();
    obstacles.back().obstacle.box.centre = place;
  }
  Cycle cycle;
  cycle.obstacles = obstacles;
  cycle.decision = decision;
  alarms.add(cycle);
}

TEST(FalseAlarms, ThreeScansInARowConfirmAnObstacleOnce) {
  FalseAlarms alarms;
  see(alarms, {{1.0, 0.0}});
  see(alarms, {{1.1, 0.0}});
  EXPECT_TRUE(alarms.confirmed().empty());
  for (int k = 0; k < 4; ++k) see(alarms, {{1.0, 0.1}});
  ASSERT_EQ(alarms.confirmed().size(), 1U);
  EXPECT_NEAR(alarms.confirmed().front().x(), 1.0, 0.2);
  EXPECT_EQ(alarms.seen(), 6U);
}

TEST(FalseAlarms, AGapStartsAgainAndAnotherPlaceIsAnotherOne) {
  FalseAlarms alarms;
  for (int k = 0; k < 5; ++k) {
    see(alarms, {{1.0, 0.0}});
    see(alarms, {{3.0, 0.0}});
  }
  EXPECT_TRUE(alarms.confirmed().empty());
  for (int k = 0; k < 3; ++k) see(alarms, {{1.0, 0.0}, {3.0, 0.0}});
  EXPECT_EQ(alarms.confirmed().size(), 2U);
}

TEST(FalseAlarms, WhatIsGoneAndComesBackIsANewOne) {
  FalseAlarms alarms;
  for (int k = 0; k < 3; ++k) see(alarms, {{1.0, 0.0}});
  for (int k = 0; k < 4; ++k) see(alarms, {});
  for (int k = 0; k < 3; ++k) see(alarms, {{1.0, 0.0}});
  EXPECT_EQ(alarms.confirmed().size(), 1U);
  for (int k = 0; k < 5; ++k) see(alarms, {});
  for (int k = 0; k < 3; ++k) see(alarms, {{1.0, 0.0}});
  EXPECT_EQ(alarms.confirmed().size(), 2U);
  alarms.next_drive();
  for (int k = 0; k < 3; ++k) see(alarms, {{1.0, 0.0}});
  EXPECT_EQ(alarms.confirmed().size(), 3U);
}

TEST(FalseAlarms, CountsEachStopAndSlowDownOnce) {
  FalseAlarms alarms;
  for (const Decision decision : {Decision::slow, Decision::slow, Decision::stop, Decision::stop, Decision::slow,
                                  Decision::ignore, Decision::stop, Decision::ignore, Decision::slow})
    see(alarms, {}, decision);
  EXPECT_EQ(alarms.stops(), 2U);
  EXPECT_EQ(alarms.slow_downs(), 2U);
}

TEST(FalseAlarms, RefusesAbsurdOptions) {
  EXPECT_THROW(FalseAlarms({.same_place = 0.0}), Error);
  EXPECT_THROW(FalseAlarms({.confirmations = 0}), Error);
}

}  // namespace
}  // namespace slamicp::false_alarms_test
