// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/false_alarms.hpp>

namespace slamicp::false_alarms_test {
namespace {

Cycle seeing(std::initializer_list<Point2> places, Decision decision = Decision::ignore) {
  Cycle cycle;
  cycle.decision = decision;
  for (const Point2& place : places) {
    EvaluatedObstacle evaluated;
    evaluated.obstacle.box.centre = place;
    cycle.obstacles.push_back(evaluated);
  }
  return cycle;
}

TEST(FalseAlarms, ThreeScansInARowConfirmAnObstacleOnce) {
  FalseAlarms alarms;
  alarms.add(seeing({{1.0, 0.0}}));
  alarms.add(seeing({{1.1, 0.0}}));
  EXPECT_TRUE(alarms.confirmed().empty());
  for (int k = 0; k < 4; ++k) alarms.add(seeing({{1.0, 0.1}}));
  ASSERT_EQ(alarms.confirmed().size(), 1U);
  EXPECT_NEAR(alarms.confirmed().front().x(), 1.0, 0.2);
  EXPECT_EQ(alarms.seen(), 6U);
}

TEST(FalseAlarms, AGapStartsAgainAndAnotherPlaceIsAnotherOne) {
  FalseAlarms alarms;
  for (int k = 0; k < 5; ++k) {
    alarms.add(seeing({{1.0, 0.0}}));
    alarms.add(seeing({{3.0, 0.0}}));
  }
  EXPECT_TRUE(alarms.confirmed().empty());
  for (int k = 0; k < 3; ++k) alarms.add(seeing({{1.0, 0.0}, {3.0, 0.0}}));
  EXPECT_EQ(alarms.confirmed().size(), 2U);
}

TEST(FalseAlarms, WhatIsGoneAndComesBackIsANewOne) {
  FalseAlarms alarms;
  for (int k = 0; k < 3; ++k) alarms.add(seeing({{1.0, 0.0}}));
  for (int k = 0; k < 4; ++k) alarms.add(seeing({}));
  for (int k = 0; k < 3; ++k) alarms.add(seeing({{1.0, 0.0}}));
  EXPECT_EQ(alarms.confirmed().size(), 1U);
  for (int k = 0; k < 5; ++k) alarms.add(seeing({}));
  for (int k = 0; k < 3; ++k) alarms.add(seeing({{1.0, 0.0}}));
  EXPECT_EQ(alarms.confirmed().size(), 2U);
  alarms.next_drive();
  for (int k = 0; k < 3; ++k) alarms.add(seeing({{1.0, 0.0}}));
  EXPECT_EQ(alarms.confirmed().size(), 3U);
}

TEST(FalseAlarms, CountsEachStopAndSlowDownOnce) {
  FalseAlarms alarms;
  for (const Decision decision : {Decision::slow, Decision::slow, Decision::stop, Decision::stop, Decision::slow,
                                  Decision::ignore, Decision::stop, Decision::ignore, Decision::slow})
    alarms.add(seeing({}, decision));
  EXPECT_EQ(alarms.stops(), 2U);
  EXPECT_EQ(alarms.slow_downs(), 2U);
}

TEST(FalseAlarms, RefusesAbsurdOptions) {
  EXPECT_THROW(FalseAlarms({.same_place = 0.0}), Error);
  EXPECT_THROW(FalseAlarms({.confirmations = 0}), Error);
}

}  // namespace
}  // namespace slamicp::false_alarms_test
