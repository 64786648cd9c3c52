// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/navigation/path_tracker.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/robot.hpp>

namespace slamicp::path_tracker_test {
namespace {

std::shared_ptr<const SplinePath> reference() {
  static const auto path = std::make_shared<const SplinePath>(route(corridor_world(), "reference").waypoints);
  return path;
}

struct Drive {
  std::vector<double> cross_track;  // where the robot really was [m]
  double fastest = 0.0;
  double longest_jolt = 0.0;  // the greatest change of speed along the path [m/s^2]
  double seconds = 0.0;
  bool finished = false;
  PoseDistance from_end;

  double rms() const {
    double sum = 0.0;
    for (const double e : cross_track) sum += e * e;
    return std::sqrt(sum / static_cast<double>(cross_track.size()));
  }
};

constexpr double period = 0.025;

/// An omnidirectional robot that knows where it is.
Drive drive(const PathTrackerOptions& options, const OmniRobotModel& model, const Pose2& aside = {},
            std::uint64_t seed = 1) {
  PathTracker tracker(reference(), options);
  SimulatedRobot robot(model, reference()->at(0.0) * aside, seed);
  Drive result;
  double speed = 0.0;
  while (result.seconds < 300.0) {
    const Tracking& tracking = tracker.update(robot.pose(), result.seconds);
    robot.command(result.seconds, tracking.command);
    result.cross_track.push_back(tracking.cross_track);
    result.fastest = std::max(result.fastest, std::hypot(robot.velocity()[0], robot.velocity()[1]));
    result.longest_jolt = std::max(result.longest_jolt, (tracking.speed - speed) / period);
    speed = tracking.speed;
    result.finished = tracking.finished;
    if (tracking.finished) break;
    result.seconds += period;
    robot.advance(result.seconds);
  }
  result.from_end = distance(robot.pose(), reference()->at(reference()->length()));
  return result;
}

TEST(PathTrackerTest, StaysOnTheReferencePathThoughWheelsSlipAndCommandsComeLate) {
  OmniRobotModel robot = apr02();
  for (const double speed : {0.15, 0.35, 0.55}) {
    const Drive drove = drive({.speed = speed}, robot);
    EXPECT_TRUE(drove.finished);
    EXPECT_LT(drove.rms(), 0.015) << speed;
    EXPECT_LT(drove.fastest, 1.1 * speed);
    EXPECT_LT(drove.longest_jolt, 0.51);
    EXPECT_LT(drove.from_end.translation, 0.02);
    EXPECT_LT(drove.from_end.rotation, 0.05);
  }
}

TEST(PathTrackerTest, ComesBackToThePath) {
  const Drive drove = drive({}, {}, {0.0, 0.3, 0.4});
  EXPECT_TRUE(drove.finished);
  EXPECT_NEAR(drove.cross_track.front(), 0.3, 1e-3);
  EXPECT_LT(std::abs(drove.cross_track[200]), 0.01) << "after five seconds";
}

TEST(PathTrackerTest, ADifferentialDriveFollowsToo) {
  PathTracker tracker(reference(), {.drive = DriveKind::differential, .speed = 0.35});
  Pose2 pose = reference()->at(0.0) * Pose2{0.0, 0.1, -0.2};
  double worst_late = 0.0;
  std::vector<VelocityCommand> pipe(2);  // 50 ms of delay
  Tracking last;
  for (int k = 0; k < 8000; ++k) {
    last = tracker.update(pose, k * period);
    EXPECT_EQ(last.command.y, 0.0);
    if (last.finished) break;
    if (k > 200) worst_late = std::max(worst_late, std::abs(last.cross_track));
    pipe.push_back(last.command);
    pose = pose * Pose2::exp(period * Pose2::Tangent(pipe[0].x, 0.0, pipe[0].turn));
    pipe.erase(pipe.begin());
  }
  EXPECT_TRUE(last.finished);
  EXPECT_LT(worst_late, 0.02);
}

TEST(PathTrackerTest, TheSpeedLimitHoldsAndStops) {
  PathTracker tracker(reference());
  Pose2 pose = reference()->at(1.0);
  Tracking last;
  for (int k = 0; k < 100; ++k) {
    last = tracker.update(pose, k * period, 0.1);
    pose = pose * Pose2::exp(period * Pose2::Tangent(last.command.x, last.command.y, last.command.turn));
  }
  EXPECT_NEAR(last.speed, 0.1, 1e-9);
  last = tracker.update(pose, 100 * period, 0.0);
  EXPECT_EQ(last.command.x, 0.0);
  EXPECT_EQ(last.command.turn, 0.0);
  EXPECT_FALSE(last.finished);
}

TEST(PathTrackerTest, AStampThatDoesNotRiseAndAPoseThatIsNoneChangeNothing) {
  PathTracker tracker(reference());
  tracker.update(reference()->at(1.0), 1.0);
  const double travelled = tracker.update(reference()->at(1.1), 1.1).travelled;
  EXPECT_EQ(tracker.update(reference()->at(2.0), 1.1).travelled, travelled);
  EXPECT_EQ(tracker.update({NAN, 0.0, 0.0}, 1.2).travelled, travelled);
}

TEST(PathTrackerTest, RefusesAbsurdOptions) {
  EXPECT_THROW(PathTracker(nullptr), Error);
  EXPECT_THROW(PathTracker(reference(), {.speed = 0.0}), Error);
  EXPECT_THROW(PathTracker(reference(), {.delay = -0.1}), Error);
  EXPECT_THROW(PathTracker(reference(), {.goal_tolerance = 0.0}), Error);
}

}  // namespace
}  // namespace slamicp::path_tracker_test
