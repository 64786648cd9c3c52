// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/simulation/person.hpp>

namespace slamicp::person_test {
namespace {

Person there_and_back() {
  Person person;
  person.way = {{1.0, 2.0}, {5.0, 2.0}, {5.0, 5.0}};
  person.speed = 1.0;
  person.pause = 2.0;
  return person;
}

Point2 middle_of(const PersonOutline& outline) { return 0.5 * (outline.centres[0] + outline.centres[1]); }

void expect_pose(const Pose2& pose, const Pose2& expected) {
  EXPECT_NEAR(pose.x, expected.x, 1e-9);
  EXPECT_NEAR(pose.y, expected.y, 1e-9);
  EXPECT_NEAR(wrap_angle(pose.theta - expected.theta), 0.0, 1e-9);
}

TEST(Person, WalksThereTurnsAtTheCornerPausesAtTheEndsAndComesBack) {
  constexpr double up = 0.5 * std::numbers::pi;
  const double quarter_turn = up / person_turn_rate;
  const Person person = there_and_back();
  EXPECT_EQ(person.problem(), "");
  expect_pose(pose_at(person, 0.0), {1.0, 2.0, 0.0});
  expect_pose(pose_at(person, 3.0), {4.0, 2.0, 0.0});
  expect_pose(pose_at(person, 4.0 + 0.5 * quarter_turn), {5.0, 2.0, 0.5 * up});
  const double end = 4.0 + quarter_turn + 3.0;
  expect_pose(pose_at(person, end - 1.0), {5.0, 4.0, up});
  expect_pose(pose_at(person, end + 1.9), {5.0, 5.0, up});
  const double back = end + 2.0 + 2.0 * quarter_turn;
  expect_pose(pose_at(person, back + 1.0), {5.0, 4.0, -up});
  const double round = back + 3.0 + quarter_turn + 4.0 + 2.0 + 2.0 * quarter_turn;
  expect_pose(pose_at(person, round - 2.0 * quarter_turn - 1.0), {1.0, 2.0, std::numbers::pi});
  expect_pose(pose_at(person, round + 3.0), {4.0, 2.0, 0.0});
  expect_pose(pose_at(person, 3.0 - 100.0 * round), {4.0, 2.0, 0.0});
}

TEST(Person, GoesRoundALoop) {
  Person person = there_and_back();
  person.is_loop = true;
  const double corner = std::atan2(-3.0, -4.0);
  const double turns = (2.5 * std::numbers::pi - wrap_angle(0.5 * std::numbers::pi - corner)) / person_turn_rate;
  double seen_last_side = 0.0;
  for (double stamp = 0.0; stamp < 12.0 + 2.0 + turns; stamp += 0.05)
    if (std::abs(wrap_angle(pose_at(person, stamp).theta - corner)) < 1e-9) seen_last_side += 0.05;
  EXPECT_NEAR(seen_last_side, 5.0 + 2.0, 0.2) << "5 m from the last corner to the first, and the pause there";
}

TEST(Person, StartsWhereTheyWouldBeAfterThatTime) {
  Person person = there_and_back();
  person.start = 2.5;
  expect_pose(pose_at(person, 1.0), pose_at(there_and_back(), 3.5));
}

TEST(Person, TheirLegsNeverJumpAndOneOfThemStandsStillInEachStep) {
  for (const bool is_loop : {false, true}) {
    Person person = there_and_back();
    person.is_loop = is_loop;
    constexpr double step = 1e-3;
    PersonOutline before = outline_at(person, 0.0);
    ASSERT_EQ(before.count, 2U);
    EXPECT_EQ(before.radius, person.leg_radius);
    double slowest = 10.0;
    double fastest = 0.0;
    for (double stamp = step; stamp < 40.0; stamp += step) {
      const PersonOutline now = outline_at(person, stamp);
      for (std::size_t k = 0; k < 2; ++k) {
        const double speed = (now.centres[k] - before.centres[k]).norm() / step;
        fastest = std::max(fastest, speed);
        if (stamp > 0.5 && stamp < 3.5) slowest = std::min(slowest, speed);
      }
      EXPECT_LT((middle_of(now) - pose_at(person, stamp).translation()).norm(), 1e-9);
      before = now;
    }
    EXPECT_LT(fastest, 2.0 * person.speed + 1e-3);
    EXPECT_GT(fastest, 1.9 * person.speed);
    EXPECT_LT(slowest, 0.05);
  }
}

TEST(Person, LegsStandAsFarApartAsTheyShould) {
  const Person person = there_and_back();
  const PersonOutline at_corner = outline_at(person, 0.0);
  EXPECT_NEAR((at_corner.centres[0] - at_corner.centres[1]).norm(), 0.24, 1e-12);
  EXPECT_NEAR(at_corner.centres[0].y(), 2.12, 1e-12) << "the left one";
}

TEST(Person, ABodyIsOneRoundThing) {
  Person person = there_and_back();
  person.shape = PersonShape::body;
  const PersonOutline outline = outline_at(person, 3.0);
  EXPECT_EQ(outline.count, 1U);
  EXPECT_EQ(outline.radius, person.body_radius);
  EXPECT_LT((outline.centres[0] - Point2(4.0, 2.0)).norm(), 1e-12);
}

TEST(Person, WithOneCornerStandsThereAndLooksWhereToldTo) {
  Person person;
  person.way = {{3.0, 4.0}};
  person.heading = 1.0;
  for (const double stamp : {0.0, 17.0}) expect_pose(pose_at(person, stamp), {3.0, 4.0, 1.0});
}

TEST(Person, TellsWhatCannotBe) {
  const auto broken = [](auto breaks) {
    Person person = there_and_back();
    breaks(person);
    return person.problem();
  };
  EXPECT_NE(broken([](Person& p) { p.way.clear(); }), "");
  EXPECT_NE(broken([](Person& p) { p.way[1] = p.way[0]; }), "");
  EXPECT_NE(broken([](Person& p) { p.way[1].x() = std::nan(""); }), "");
  EXPECT_NE(broken([](Person& p) { p.speed = 0.0; }), "");
  EXPECT_NE(broken([](Person& p) { p.pause = -1.0; }), "");
  EXPECT_NE(broken([](Person& p) { p.step_length = 0.0; }), "");
  EXPECT_NE(broken([](Person& p) { p.leg_radius = -0.1; }), "");
  EXPECT_NE(broken([](Person& p) { p.is_loop = true, p.way.push_back(p.way.front()); }), "");
}

}  // namespace
}  // namespace slamicp::person_test
