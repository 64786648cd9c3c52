// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>

#include "support/room.hpp"

namespace slamicp::localizer_test {
namespace {

using test::nan;
using test::pi;
using test::Room;

void expect_near(const Pose2& pose, const Pose2& truth, double metres, double radians) {
  EXPECT_LE(distance(pose, truth).translation, metres) << to_string(pose) << " is not " << to_string(truth);
  EXPECT_LE(distance(pose, truth).rotation, radians) << to_string(pose) << " is not " << to_string(truth);
}

struct Scene {
  Room room = test::simple_room();
  PointMap2::Pointer map = PointMap2::create(room.map(0.01));
  Pose2 start{1.5, 1.2, 0.4};

  Localizer localizer(const LocalizerOptions& options = {}) const {
    Localizer localizer(map, options);
    localizer.set_pose(start);
    return localizer;
  }
};

// A scan in which nothing came back: the Fix carries the prediction, so predictions can be read off exactly.
LaserScan blind(double stamp, std::optional<Pose2> odometry = {}) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.T_odom_robot = odometry;
  return scan;
}

TEST(LocalizerTest, FollowsARobotByItsScansAlone) {
  const Scene scene;
  Localizer localizer = scene.localizer();
  Pose2 truth = scene.start;
  for (int k = 0; k < 60; ++k) {
    const Fix& fix = localizer.update(scene.room.scan(truth, 0.1 * k));
    ASSERT_TRUE(fix.usable()) << fix.brief();
    expect_near(fix.pose, truth, 0.002, 0.001);
    EXPECT_EQ(fix.stamp, 0.1 * k);
    EXPECT_TRUE(fix.outliers().empty());
    truth = truth * Pose2{0.04, 0.0, 0.02};
  }
}

TEST(LocalizerTest, PredictsByOdometryInAFrameOfItsOwn) {
  const Scene scene;
  Localizer localizer = scene.localizer();
  const Pose2 T_odom_map{-7.0, 3.0, 2.0};
  Pose2 truth = scene.start;
  for (int k = 0; k < 8; ++k) {  // 0.4 m and 0.3 rad a scan: too far without odometry
    LaserScan scan = scene.room.scan(truth, 0.1 * k);
    scan.T_odom_robot = T_odom_map * truth;
    const Fix& fix = localizer.update(scan);
    expect_near(fix.predicted, truth, 0.003, 0.002);
    expect_near(fix.pose, truth, 0.002, 0.001);
    truth = truth * Pose2{0.4, 0.05, 0.3};
  }
}

TEST(LocalizerTest, PredictsByConstantVelocityInProportionToTheTime) {
  const Scene scene;
  Localizer localizer = scene.localizer();
  const Pose2 motion{0.05, 0.01, 0.03};
  localizer.update(scene.room.scan(scene.start, 1.0));
  localizer.update(scene.room.scan(scene.start * motion, 1.1));
  const Pose2 last = localizer.fix().pose;
  expect_near(Localizer(localizer.fix().map).fix().pose, {}, 0, 0);
  expect_near(localizer.update(blind(1.3)).predicted, last * interpolate(motion, 2.0), 0.005, 0.003);
}

Pose2 predicted_after(double first, double second, double third) {
  const Scene scene;
  Localizer localizer = scene.localizer();
  localizer.update(scene.room.scan(scene.start, first));
  localizer.update(scene.room.scan(scene.start * Pose2{0.05, 0, 0}, second));
  const Pose2 last = localizer.fix().pose;
  return last.inverse() * localizer.update(blind(third)).predicted;
}

TEST(LocalizerTest, StampsThatStandStillOrRunBackwardsCountAsEvenlySpaced) {
  expect_near(predicted_after(1.0, 1.1, 1.2), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(1.0, 1.1, 1.1), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(1.0, 1.1, 0.2), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(1.0, 1.0, 1.0), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(1.0, 0.5, 0.6), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(nan, 1.0, 2.0), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(1.0, 1.1, nan), {0.05, 0, 0}, 0.002, 0.001);
  expect_near(predicted_after(1.0, 1.1, 100.0), {0.15, 0, 0}, 0.006, 0.003);  // it does not fly far
}

TEST(LocalizerTest, AScanThatShowsNothingCarriesThePrediction) {
  const Scene scene;
  Localizer localizer = scene.localizer();
  LaserScan scan = scene.room.scan(scene.start, 0.0);
  scan.T_odom_robot = Pose2{};
  const Pose2 seen = localizer.update(scan).pose;
  const Fix& fix = localizer.update(blind(0.1, Pose2{0.2, 0.1, 0.3}));
  EXPECT_FALSE(fix.usable());
  EXPECT_EQ(fix.stop(), Stop::too_few_points);
  expect_near(fix.pose, seen * Pose2{0.2, 0.1, 0.3}, 1e-12, 1e-12);
  expect_near(fix.pose, fix.predicted, 0, 0);
  scan = scene.room.scan(scene.start * Pose2{0.4, 0.2, 0.6}, 0.2);
  scan.T_odom_robot = Pose2{0.2, 0.1, 0.3} * Pose2{0.2, 0.1, 0.3};
  EXPECT_TRUE(localizer.update(scan).usable()) << "and finds its way back";
}

TEST(LocalizerTest, OdometryThatIsNoNumberOrAbsurdDoesNotStopTheRobot) {
  const Scene scene;
  for (const Pose2& absurd : {Pose2{nan, 0, 0}, Pose2{0, test::infinity, 0}, Pose2{1.7e308, -1.7e308, 1}}) {
    Localizer localizer = scene.localizer();
    for (int k = 0; k < 4; ++k) {
      LaserScan scan = scene.room.scan(scene.start, 0.1 * k);
      scan.T_odom_robot = k % 2 == 0 ? absurd : Pose2{-absurd.x, -absurd.y, 0.5};
      EXPECT_TRUE(localizer.update(scan).pose.is_finite());
    }
  }
}

TEST(LocalizerTest, AScanOfNonsenseDoesNotStopTheRobot) {
  const Scene scene;
  LaserScan nonsense = scene.room.scan(scene.start);
  nonsense.angle_increment = nan;
  LaserScan nowhere = scene.room.scan(scene.start);
  nowhere.T_robot_laser.x = test::infinity;
  for (const LaserScan& scan : {nonsense, nowhere, LaserScan{}}) {
    Localizer with_map = scene.localizer();
    EXPECT_FALSE(with_map.update(scan).usable());
    expect_near(with_map.fix().pose, scene.start, 0, 0);
    Localizer scan_to_scan;
    scan_to_scan.set_pose(scene.start);
    EXPECT_FALSE(scan_to_scan.update(scan).usable());
    EXPECT_EQ(scan_to_scan.map(), nullptr);
    EXPECT_TRUE(scan_to_scan.update(scene.room.scan(scene.start)).usable()) << "the next one can still begin a map";
  }
}

TEST(LocalizerTest, ShowsWhatTheMapDoesNotKnow) {
  const Scene scene;
  Room with_box = scene.room;
  with_box.add_box({3.0, 1.8}, 0.4, 0.3, 0.5);
  Localizer localizer = scene.localizer();
  const Fix& fix = localizer.update(with_box.scan(scene.start));
  ASSERT_GT(fix.outliers().size(), 20U);
  ASSERT_EQ(fix.outliers().size(), fix.outliers_in_map().size());
  for (std::size_t k = 0; k < fix.outliers().size(); ++k) {
    EXPECT_LT((fix.outliers_in_map()[k] - Point2(3.0, 1.8)).norm(), 0.26);
    const auto i = static_cast<std::size_t>(fix.outliers()[k]);
    EXPECT_LT((fix.pose * fix.scan.in_robot[i] - fix.outliers_in_map()[k]).norm(), 1e-12);
  }
}

TEST(LocalizerTest, AFixKeepsItsSnapshotAlive) {
  const Scene scene;
  Localizer localizer(PointMap2::create(scene.room.map(0.01)));
  localizer.set_pose(scene.start);
  localizer.update(scene.room.scan(scene.start));
  const Fix kept = localizer.fix();
  const std::weak_ptr<const PointMap2> old = kept.map;
  localizer.set_map(scene.map);
  EXPECT_EQ(localizer.map(), scene.map);
  localizer.update(scene.room.scan(scene.start));
  EXPECT_FALSE(old.expired());
  EXPECT_GT(kept.map->size(), 1000U);
  EXPECT_EQ(localizer.fix().map, scene.map);
}

TEST(LocalizerTest, SetPoseForgetsTheMotion) {
  const Scene scene;
  Localizer localizer = scene.localizer();
  localizer.update(scene.room.scan(scene.start, 0.0));
  localizer.update(scene.room.scan(scene.start * Pose2{0.05, 0, 0}, 0.1));
  localizer.set_pose({2, 2, 7.0});
  expect_near(localizer.update(blind(0.2)).pose, {2, 2, 7.0 - 2.0 * pi}, 1e-12, 1e-12);
}

TEST(LocalizerTest, WithoutAMapItWorksScanToScan) {
  // Section 2.3, Figures 2 and 3 of the paper, without noise: the pose of the second scan in the first one's frame.
  const Room room = test::simple_room();
  const Pose2 first{1.5, 1.2, 0.4};
  const Pose2 motion{0.06, -0.02, 0.05};
  Localizer localizer;
  localizer.set_pose(first);
  EXPECT_EQ(localizer.map(), nullptr);
  const Fix& fix = localizer.update(room.scan(first));
  EXPECT_TRUE(fix.usable());
  expect_near(fix.pose, first, 0, 0);
  expect_near(localizer.update(room.scan(first * motion)).pose, first * motion, 1e-3, 1e-3);
}

TEST(LocalizerTest, ScanToScanAddsUp) {
  const Room room = test::simple_room();
  Localizer localizer;
  Pose2 truth{1.5, 1.2, 0.4};
  localizer.set_pose(truth);
  for (int k = 0; k < 30; ++k) {
    const Fix& fix = localizer.update(room.scan(truth, 0.1 * k));
    ASSERT_TRUE(fix.usable());
    expect_near(fix.pose, truth, 0.02, 0.02);
    truth = truth * Pose2{0.04, 0.0, 0.02};
  }
}

TEST(LocalizerTest, OutputsAreThoseAskedFor) {
  const Scene scene;
  Localizer localizer = scene.localizer({.outputs = {}});
  const Fix& fix = localizer.update(scene.room.scan(scene.start));
  EXPECT_TRUE(fix.usable());
  EXPECT_EQ(fix.match.inliers, 0U);
  Localizer all = scene.localizer({.outputs = Outputs::all()});
  const Fix& full = all.update(scene.room.scan(scene.start));
  EXPECT_EQ(full.match.matches.size(), full.scan.in_robot.size());
}

TEST(LocalizerTest, WrongUseIsRefused) {
  const Scene scene;
  EXPECT_THROW(Localizer(PointMap2::Pointer{}), Error);
  EXPECT_THROW(Localizer(scene.map, {.max_correspondence_distance = -1.0}), Error);
  EXPECT_THROW(Localizer(scene.map, {.ranges = {.min_range = -0.1}}), Error);
  EXPECT_THROW(Localizer(scene.map, {.ranges = {.min_range = 2.0, .max_range = 1.0}}), Error);
  Localizer localizer = scene.localizer();
  EXPECT_THROW(localizer.set_map(nullptr), Error);
  EXPECT_THROW(localizer.set_pose({0, nan, 0}), Error);
  const PointMap2::Pointer bare = PointMap2::create(scene.room.map(0.05), {.neighbours = 0});
  EXPECT_THROW(localizer.set_map(bare), Error) << "update() could not report it";
  EXPECT_NO_THROW(Localizer(bare, {.method = Method::point_to_point}));
  expect_near(localizer.update(scene.room.scan(scene.start)).pose, scene.start, 0.002, 0.001);
}

TEST(LocalizerOptionsTest, BecomeThoseOfTheMatch) {
  const LocalizerOptions options{.max_correspondence_distance = 0.5,
                                 .outlier_distance = 0.2,
                                 .method = Method::point_to_point,
                                 .max_iterations = 7,
                                 .kernel = RobustKernel::cauchy,
                                 .kernel_scale = 0.03,
                                 .final_gate = 0.1};
  const IcpOptions icp = options.icp();
  EXPECT_EQ(icp.max_correspondence_distance, 0.5);
  EXPECT_EQ(icp.outlier_distance, 0.2);
  EXPECT_EQ(icp.method, Method::point_to_point);
  EXPECT_EQ(icp.max_iterations, 7);
  EXPECT_EQ(icp.kernel, RobustKernel::cauchy);
  EXPECT_EQ(icp.kernel_scale, 0.03);
  EXPECT_EQ(icp.final_gate, 0.1);
}

}  // namespace
}  // namespace slamicp::localizer_test
