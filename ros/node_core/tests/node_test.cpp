// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <slamicp_node/node.hpp>

#include <slamicp/geometry/planar.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/map/occupancy_grid.hpp>
#include <slamicp/scan/motion_track.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "frames.hpp"
#include "room.hpp"

namespace slamicp::node_test {
namespace {

using node::Node;
using node::NodeOptions;
using node::Output;
using node::room;
using node::Stamp;
using node::State;

/// Its walls lie in the middle of their cells.
node::Grid grid_of(const World& world) {
  Random random(1);
  const PointCloud2 points = sample_map(world, 0.02, 0.0, random);
  const OccupancyGrid cells = to_occupancy_grid(points, {.resolution = 0.05, .origin = {0.025, 0.025, 0.0}});
  node::Grid grid;
  grid.frame = "map";
  grid.resolution = cells.resolution;
  grid.width = cells.width;
  grid.height = cells.height;
  grid.origin = {cells.T_map_grid.x, cells.T_map_grid.y, 0.0};
  for (const CellState cell : cells.cells) grid.cells.push_back(cell == CellState::occupied ? 100 : 0);
  return grid;
}

node::Transform transform(double stamp, const std::string& frame, const std::string& child, const Pose2& pose) {
  return {Stamp::from_seconds(stamp),
          frame,
          child,
          {pose.x, pose.y, 0.0},
          {0.0, 0.0, std::sin(0.5 * pose.theta), std::cos(0.5 * pose.theta)}};
}

const SimulatedRun& drive() {
  static const SimulatedRun run = node::drive_through(room(), DriveOptions().lidar.sweep_time);
  return run;
}

/// A node, and what a robot would say to it.
struct Robot {
  explicit Robot(const NodeOptions& options = {}, bool played = false) : node(options, played) {}

  static NodeOptions at_start() {
    NodeOptions options;
    const Pose2& pose = drive().truth.front().pose;
    options.initial_pose_x = pose.x + 0.05;
    options.initial_pose_y = pose.y - 0.05;
    options.initial_pose_a = pose.theta;
    return options;
  }

  void mount() { node.take_transform(transform(0.0, "base_link", "laser", {}), true); }
  void odometry(double stamp, const Pose2& pose) {
    node.take_transform(transform(stamp, "odom", "base_link", pose), false);
  }
  void send(const LaserScan& scan, double now) {
    message.stamp = Stamp::from_seconds(scan.stamp);
    message.frame = "laser";
    message.angle_min = static_cast<float>(scan.angle_min);
    message.angle_increment = static_cast<float>(scan.angle_increment);
    message.range_min = 0.1F;
    message.range_max = 30.0F;
    message.ranges = scan.ranges.data();
    message.count = scan.ranges.size();
    node.take_scan(0, message, Stamp::from_seconds(now));
  }
  const Output* step(double now) { return node.step(Stamp::from_seconds(now)); }
  State state(double now) const { return node.state(Stamp::from_seconds(now)); }
  std::string value(const std::string& key, double now) const {
    for (const auto& [name, value] : node.diagnostic(Stamp::from_seconds(now)).values)
      if (name == key) return value;
    return "none";
  }

  /// Scans `from` to `to` of the drive with their odometry, all in time, as if `later` had passed since.
  const Output* follow(std::size_t from, std::size_t to, double later = 0.0) {
    const Output* last = nullptr;
    for (std::size_t k = from; k < to; ++k) {
      LaserScan scan = drive().scans[k];
      scan.stamp += later;
      odometry(scan.stamp, *scan.T_odom_robot);
      send(scan, scan.stamp);
      last = step(scan.stamp);
    }
    return last;
  }
  double error_at(std::size_t k) const {
    const node::PlanarPose& pose = node.last()->pose;
    return std::hypot(pose.x - drive().truth[k].pose.x, pose.y - drive().truth[k].pose.y);
  }

  Node node;
  node::Scan message;
};

bool give_map(Robot& robot, const node::Grid& grid) {
  std::string problem;
  const bool taken = robot.node.take_map(grid, problem);
  EXPECT_EQ(taken, problem.empty()) << problem;
  return taken;
}

/// Ready to go.
Robot robot_in_room(const NodeOptions& options = Robot::at_start(), bool played = false) {
  Robot robot(options, played);
  robot.mount();
  EXPECT_TRUE(give_map(robot, grid_of(room())));
  return robot;
}

TEST(Node, SaysWhatItWaitsFor) {
  NodeOptions options = Robot::at_start();
  options.wait_for_initial_pose = true;
  Robot robot(options);
  const LaserScan& scan = drive().scans[0];
  double now = scan.stamp;
  robot.send(scan, now);
  EXPECT_EQ(robot.step(now), nullptr);
  EXPECT_EQ(robot.state(now), State::waiting_for_map);
  give_map(robot, grid_of(room()));
  EXPECT_EQ(robot.state(now), State::waiting_for_pose);
  std::string problem;
  node::GivenPose pose;
  pose.frame = "odom";
  EXPECT_FALSE(robot.node.take_pose(pose, problem));
  EXPECT_NE(problem.find("odom"), std::string::npos);
  pose.frame = "/map";
  pose.position = {drive().truth[0].pose.x, drive().truth[0].pose.y, 0.0};
  pose.orientation.z = std::sin(0.5 * drive().truth[0].pose.theta);
  pose.orientation.w = std::cos(0.5 * drive().truth[0].pose.theta);
  EXPECT_TRUE(robot.node.take_pose(pose, problem));

  const auto next = [&](std::size_t k) {
    now = drive().scans[k].stamp;
    robot.send(drive().scans[k], now);
    return robot.step(now);
  };
  EXPECT_EQ(next(1), nullptr);
  EXPECT_EQ(robot.state(now), State::waiting_for_frames);
  EXPECT_NE(robot.node.diagnostic(Stamp::from_seconds(now)).message.find("'laser'"), std::string::npos);
  robot.mount();
  EXPECT_EQ(robot.step(now), nullptr);
  EXPECT_EQ(robot.state(now), State::waiting_for_odometry);
  robot.odometry(now, *drive().scans[1].T_odom_robot);
  ASSERT_NE(robot.step(now), nullptr);
  EXPECT_EQ(robot.state(now), State::localizing);
  EXPECT_LT(robot.error_at(1), 0.02);
  EXPECT_EQ(robot.state(now + 0.9), State::localizing);
  EXPECT_EQ(robot.state(now + 1.1), State::waiting_for_scan);
  EXPECT_EQ(robot.node.diagnostic(Stamp::from_seconds(now + 1.1)).level, 3);
}

TEST(Node, FollowsTheRobotAndTellsTf) {
  Robot robot = robot_in_room();
  const std::size_t last = drive().scans.size() - 1;
  ASSERT_NE(robot.follow(0, last + 1), nullptr);
  EXPECT_LT(robot.error_at(last), 0.03);
  const Output& output = *robot.node.last();
  EXPECT_EQ(output.stamp.nanoseconds, Stamp::from_seconds(drive().scans[last].stamp).nanoseconds);
  ASSERT_TRUE(output.has_transform);
  EXPECT_EQ(output.frame, "map");
  EXPECT_EQ(output.child, "odom");
  EXPECT_NEAR(1e-9 * static_cast<double>(output.transform_stamp.nanoseconds - output.stamp.nanoseconds), 0.1, 1e-6);
  const Pose2 T_map_odom{output.transform.x, output.transform.y, output.transform.theta};
  const Pose2 T_map_base = T_map_odom * *drive().scans[last].T_odom_robot;
  EXPECT_NEAR(T_map_base.x, output.pose.x, 1e-9);
  EXPECT_NEAR(T_map_base.y, output.pose.y, 1e-9);
  EXPECT_GT(output.covariance[0], 0.0);
  EXPECT_GT(output.covariance[35], 0.0);
  EXPECT_NEAR(output.covariance[6], output.covariance[1], 1e-15);
  EXPECT_EQ(output.outliers.size() + output.inliers.size(), static_cast<std::size_t>(output.status.points));
}

TEST(Node, GivesTheSamePosesAsTheLocalizer) {
  Robot robot = robot_in_room();
  const std::string file = (std::filesystem::path(testing::TempDir()) / "node_room.yaml").string();
  std::string problem;
  ASSERT_TRUE(robot.node.save_map(file, problem)) << problem;
  NodeOptions options = Robot::at_start();
  options.map_file = file;
  robot = Robot(options);
  robot.mount();
  Localizer localizer(load_map(file));
  localizer.set_pose({options.initial_pose_x, options.initial_pose_y, options.initial_pose_a});
  std::vector<MotionTrack::Sample> samples;
  for (const LaserScan& scan : drive().scans) {
    const node::Transform told = transform(scan.stamp, "odom", "base_link", *scan.T_odom_robot);
    samples.push_back({told.stamp.seconds(), planar(*node::pose_of(told.translation, told.rotation))});
  }
  const MotionTrack wheels(samples);
  for (std::size_t k = 0; k < drive().scans.size(); ++k) {
    ASSERT_NE(robot.follow(k, k + 1), nullptr);
    LaserScan scan = drive().scans[k];
    scan.stamp = Stamp::from_seconds(scan.stamp).seconds();
    scan.angle_min = static_cast<double>(robot.message.angle_min);
    scan.angle_increment = static_cast<double>(robot.message.angle_increment);
    scan.range_min = static_cast<double>(0.1F);
    scan.range_max = 30.0;
    set_odometry(wheels, scan);
    const Fix& fix = localizer.update(scan);
    ASSERT_NEAR(robot.node.last()->pose.x, fix.pose.x, 1e-9) << k;
    ASSERT_NEAR(robot.node.last()->pose.y, fix.pose.y, 1e-9) << k;
    ASSERT_NEAR(robot.node.last()->pose.theta, fix.pose.theta, 1e-9) << k;
  }
}

TEST(Node, ShowsWhatTheMapDoesNotHave) {
  Robot robot(Robot::at_start());
  robot.mount();
  World without = room();
  without.pillars.clear();
  give_map(robot, grid_of(without));
  const Output* const output = robot.follow(0, 12);
  ASSERT_NE(output, nullptr);
  ASSERT_FALSE(output->obstacles.empty());
  const node::Obstacle& pillar = output->obstacles.front();
  EXPECT_NEAR(pillar.x, 3.0, 0.1);
  EXPECT_NEAR(pillar.y, 6.0, 0.15);
  EXPECT_GT(pillar.id, 0);
  ASSERT_FALSE(output->outliers.empty());
  // In the laser's frame: seen from there they are where the pillar is.
  const Pose2 T_map_laser{output->pose.x, output->pose.y, output->pose.theta};
  const Point2 in_map =
      T_map_laser * Point2(static_cast<double>(output->outliers[0].x), static_cast<double>(output->outliers[0].y));
  EXPECT_NEAR((in_map - Point2(3.0, 6.0)).norm(), 0.3, 0.1);
}

TEST(Node, WaitsForLateOdometryAndGoesOnWithoutIt) {
  Robot robot = robot_in_room();
  robot.follow(0, 10);
  const LaserScan& late = drive().scans[10];
  robot.send(late, late.stamp);
  EXPECT_EQ(robot.step(late.stamp), nullptr) << "odometry does not reach it yet";
  robot.odometry(late.stamp, *late.T_odom_robot);
  ASSERT_NE(robot.step(late.stamp + 0.05), nullptr);
  EXPECT_NEAR(robot.node.last()->status.waited, 0.05, 1e-6);
  // None from here on.
  for (std::size_t k = 11; k < 30; ++k) {
    const double now = drive().scans[k].stamp;
    robot.send(drive().scans[k], now);
    EXPECT_EQ(robot.step(now + 0.09), nullptr);
    ASSERT_NE(robot.step(now + 0.11), nullptr);
    EXPECT_LT(robot.error_at(k), 0.04) << k;
  }
  EXPECT_FALSE(robot.node.last()->status.had_odometry);
  EXPECT_FALSE(robot.node.last()->has_transform);
  EXPECT_EQ(robot.node.diagnostic(Stamp::from_seconds(drive().scans[29].stamp)).level, 1);
  ASSERT_NE(robot.follow(30, 35), nullptr);
  EXPECT_TRUE(robot.node.last()->has_transform);
  EXPECT_LT(robot.error_at(34), 0.03);
}

TEST(Node, OdometryThatIsSetToZeroMovesNoRobot) {
  Robot robot = robot_in_room();
  robot.follow(0, 15);
  const Pose2 away = Pose2{5.0, -3.0, 1.0};
  for (std::size_t k = 15; k < 30; ++k) {
    const LaserScan& scan = drive().scans[k];
    robot.odometry(scan.stamp, away * *scan.T_odom_robot);
    robot.send(scan, scan.stamp);
    ASSERT_NE(robot.step(scan.stamp), nullptr);
    EXPECT_LT(robot.error_at(k), 0.04) << k;
  }
  EXPECT_EQ(robot.value("odometry jumps", drive().scans[29].stamp), "1");
  EXPECT_TRUE(robot.node.last()->status.had_odometry);
}

TEST(Node, OdometryWhoseStampsJumpBackBeginsAnew) {
  Robot robot = robot_in_room();
  robot.follow(0, 10);
  robot.odometry(drive().scans[10].stamp - 100.0, {});
  const LaserScan& scan = drive().scans[10];
  robot.send(scan, scan.stamp);
  EXPECT_EQ(robot.step(scan.stamp), nullptr);
  ASSERT_NE(robot.step(scan.stamp + 0.2), nullptr) << "goes on without";
  ASSERT_NE(robot.follow(11, 20), nullptr);
  EXPECT_LT(robot.error_at(19), 0.03);
}

TEST(Node, NoticesWheelsThatStandWhileTheRobotGoes) {
  Robot robot = robot_in_room();
  robot.follow(0, 10);
  const Pose2 frozen = *drive().scans[9].T_odom_robot;
  const std::size_t last = 60;
  for (std::size_t k = 10; k < last; ++k) {
    const LaserScan& scan = drive().scans[k];
    robot.odometry(scan.stamp, frozen);
    robot.send(scan, scan.stamp);
    ASSERT_NE(robot.step(scan.stamp), nullptr);
    EXPECT_LT(robot.error_at(k), 0.1) << k;
  }
  const double now = drive().scans[last - 1].stamp;
  EXPECT_EQ(robot.value("odometry frozen", now), "yes");
  EXPECT_EQ(robot.node.diagnostic(Stamp::from_seconds(now)).level, 1);
  robot.follow(last, last + 5);
  EXPECT_EQ(robot.value("odometry frozen", now), "no");
}

TEST(Node, LivesThroughScansThatAreBroken) {
  Robot robot = robot_in_room();
  robot.follow(0, 10);
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  std::size_t k = 10;
  const auto send_changed = [&](const std::function<void(LaserScan&)>& change) {
    LaserScan scan = drive().scans[k++];
    robot.odometry(scan.stamp, *scan.T_odom_robot);
    change(scan);
    robot.send(scan, scan.stamp);
    return robot.step(scan.stamp);
  };
  // Every third reading is not a number, every third infinite: the rest will do.
  ASSERT_NE(send_changed([&](LaserScan& scan) {
              for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam)
                if (beam % 3 != 0) scan.ranges[beam] = beam % 3 == 1 ? nan : inf;
            }),
            nullptr);
  EXPECT_TRUE(robot.node.last()->status.usable);
  EXPECT_LT(robot.error_at(k - 1), 0.04);
  // All of them: the pose goes on by odometry.
  ASSERT_NE(send_changed([&](LaserScan& scan) { std::fill(scan.ranges.begin(), scan.ranges.end(), nan); }), nullptr);
  EXPECT_EQ(robot.node.last()->status.stop, "too_few_points");
  EXPECT_LT(robot.error_at(k - 1), 0.05);
  ASSERT_NE(send_changed([&](LaserScan& scan) { scan.ranges.clear(); }), nullptr) << "no beams at all";
  EXPECT_EQ(robot.node.last()->status.stop, "too_few_points");
  EXPECT_TRUE(robot.node.last()->outliers.empty());
  // No direction: left out.
  EXPECT_EQ(send_changed([&](LaserScan& scan) { scan.angle_increment = std::numeric_limits<double>::quiet_NaN(); }),
            nullptr);
  // Every other beam only: another geometry.
  ASSERT_NE(send_changed([&](LaserScan& scan) {
              std::vector<float> half;
              for (std::size_t beam = 0; beam < scan.ranges.size(); beam += 2) half.push_back(scan.ranges[beam]);
              scan.ranges = half;
              scan.angle_increment *= 2.0;
            }),
            nullptr);
  EXPECT_LT(robot.error_at(k - 1), 0.03);
  EXPECT_NE(robot.value("beams changed", drive().scans[k].stamp), "0");
  ASSERT_NE(robot.follow(k, k + 5), nullptr);
  EXPECT_LT(robot.error_at(k + 4), 0.03);
}

TEST(Node, TakesAnotherMapWhileItRuns) {
  Robot robot = robot_in_room();
  robot.follow(0, 10);
  World other = room();
  other.pillars.clear();
  give_map(robot, grid_of(other));
  ASSERT_NE(robot.follow(10, 20), nullptr);
  EXPECT_LT(robot.error_at(19), 0.03);
  EXPECT_FALSE(robot.node.last()->obstacles.empty()) << "the pillar is not in the new map";
  node::Grid empty = grid_of(room());
  std::fill(empty.cells.begin(), empty.cells.end(), std::int8_t{0});
  std::string problem;
  EXPECT_FALSE(robot.node.take_map(empty, problem));
  empty.cells.pop_back();
  EXPECT_FALSE(robot.node.take_map(empty, problem));
  ASSERT_NE(robot.follow(20, 25), nullptr) << "in the old one";
  EXPECT_LT(robot.error_at(24), 0.03);
}

TEST(Node, ARecordingThatBeginsAgainBeginsAtItsStart) {
  Robot robot = robot_in_room(Robot::at_start(), true);
  robot.follow(0, 60);
  ASSERT_NE(robot.follow(0, 10), nullptr) << "the clock has jumped back";
  EXPECT_LT(robot.error_at(9), 0.03);
  EXPECT_EQ(robot.value("time began again", drive().scans[9].stamp), "1");
}

TEST(Node, AClockThatIsSetBackMovesNoRobot) {
  Robot robot = robot_in_room();
  robot.follow(0, 30);
  ASSERT_NE(robot.follow(30, 50, -500.0), nullptr);
  EXPECT_LT(robot.error_at(49), 0.03);
  EXPECT_EQ(robot.value("time began again", drive().scans[49].stamp - 500.0), "1");
}

TEST(Node, ScansThatComeTwiceOrLateAreLeftOut) {
  Robot robot = robot_in_room();
  robot.follow(0, 5);
  robot.send(drive().scans[4], drive().scans[4].stamp);
  robot.send(drive().scans[2], drive().scans[4].stamp);
  EXPECT_EQ(robot.step(drive().scans[4].stamp), nullptr);
  EXPECT_EQ(robot.value("scans dropped", drive().scans[4].stamp), "2");
}

TEST(Node, ASweepThatCannotTakeSoLongIsTakenAsAnInstant) {
  Robot robot = robot_in_room();
  robot.message.time_increment = 0.01F;  // 5.4 s for a sweep, ten of which come in a second
  robot.message.scan_time = 0.1F;
  ASSERT_NE(robot.follow(0, 20), nullptr) << "else they would wait for odometry";
  EXPECT_LT(robot.error_at(19), 0.03);
}

TEST(Node, FindsTheRobotThatWasPutElsewhere) {
  Robot robot = robot_in_room();
  robot.follow(0, 20);
  std::string problem;
  node::GivenPose wrong;
  wrong.position = {drive().truth[20].pose.x + 1.5, drive().truth[20].pose.y - 1.0, 0.0};
  ASSERT_TRUE(robot.node.take_pose(wrong, problem));
  robot.follow(20, 80);
  EXPECT_LT(robot.error_at(79), 0.05);
  EXPECT_GE(robot.node.last()->status.recoveries, 1U);
}

TEST(Node, WithoutOdometryTfGoesToTheBase) {
  NodeOptions options = Robot::at_start();
  options.use_odometry = false;
  Robot robot = robot_in_room(options);
  for (std::size_t k = 0; k < 30; ++k) {
    robot.send(drive().scans[k], drive().scans[k].stamp);
    ASSERT_NE(robot.step(drive().scans[k].stamp), nullptr);
  }
  EXPECT_LT(robot.error_at(29), 0.04);
  EXPECT_EQ(robot.node.last()->child, "base_link");
}

TEST(Node, ALaserThatHangsUpsideDownSeesTheSame) {
  Robot robot(Robot::at_start());
  give_map(robot, grid_of(room()));
  node::Transform hanging = transform(0.0, "base_link", "laser", {});
  hanging.rotation = {1.0, 0.0, 0.0, 0.0};
  hanging.translation.z = 0.4;
  robot.node.take_transform(hanging, true);
  for (std::size_t k = 0; k < 20; ++k) {
    LaserScan scan = drive().scans[k];
    scan.angle_min = -scan.angle_min;
    scan.angle_increment = -scan.angle_increment;
    robot.odometry(scan.stamp, *scan.T_odom_robot);
    robot.send(scan, scan.stamp);
    ASSERT_NE(robot.step(scan.stamp), nullptr);
  }
  EXPECT_LT(robot.error_at(19), 0.03);
  for (const node::Point& point : robot.node.last()->inliers) ASSERT_NEAR(point.z, 0.0F, 1e-5F);
}

TEST(Node, OverSeveralFramesAndByTopic) {
  NodeOptions options = Robot::at_start();
  options.odom_topic = "odom";
  Robot robot(options);
  give_map(robot, grid_of(room()));
  robot.node.take_transform(transform(0.0, "base_link", "mast", {0.3, 0.0, 0.5}), true);
  robot.node.take_transform(transform(0.0, "mast", "laser", Pose2{0.3, 0.0, 0.5}.inverse()), true);
  for (std::size_t k = 0; k < 20; ++k) {
    const LaserScan& scan = drive().scans[k];
    const Stamp now = Stamp::from_seconds(scan.stamp);
    robot.node.take_odometry(transform(scan.stamp, "odom", "base_link", *scan.T_odom_robot), now);
    robot.send(scan, scan.stamp);
    ASSERT_NE(robot.step(scan.stamp), nullptr);
  }
  EXPECT_LT(robot.error_at(19), 0.03);
}

TEST(Node, MakesAMap) {
  NodeOptions options = Robot::at_start();
  options.mode = "mapping";
  Robot robot(options, true);
  robot.mount();
  ASSERT_NE(robot.follow(0, 100), nullptr);
  const double now = drive().scans[99].stamp;
  EXPECT_EQ(robot.state(now), State::mapping);
  const node::Grid* const grid = robot.node.new_map(Stamp::from_seconds(now));
  ASSERT_NE(grid, nullptr);
  EXPECT_GT(grid->width, 200);
  EXPECT_EQ(robot.node.new_map(Stamp::from_seconds(now + 1.0)), nullptr) << "not again so soon";
  EXPECT_EQ(robot.follow(0, 5, -1.0), nullptr) << "the recording begins again: nothing is mapped twice";
  EXPECT_EQ(robot.node.new_map(Stamp::from_seconds(now + 10.0)), nullptr);
  const auto folder = std::filesystem::path(testing::TempDir());
  std::string problem;
  for (const char* name : {"made.yaml", "made.pcd"}) {
    ASSERT_TRUE(robot.node.save_map((folder / name).string(), problem)) << problem;
    Robot other([&] {
      NodeOptions in_it = Robot::at_start();
      in_it.map_file = (folder / name).string();
      return in_it;
    }());
    other.mount();
    ASSERT_NE(other.node.new_map({}), nullptr) << "the file's map is published";
    ASSERT_NE(other.follow(0, 20), nullptr) << name;
    EXPECT_LT(other.error_at(19), 0.12) << name;
  }
  EXPECT_FALSE(robot.node.save_map("/nowhere/at/all.yaml", problem));
  EXPECT_FALSE(problem.empty());
}

}  // namespace
}  // namespace slamicp::node_test
