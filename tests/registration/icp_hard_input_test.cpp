// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/registration/icp.hpp>

#include "support/clouds.hpp"

namespace slamicp::icp_hard_input_test {
namespace {

using test::infinity;
using test::nan;
using test::wall;

constexpr Method methods[] = {Method::point_to_point, Method::point_to_line};

template <int D>
IcpResult<D> match(const PointCloud<D>& map, const PointCloud<D>& scan, const Pose<D>& guess, Method method) {
  const IcpResult<D> result = Icp<D>({.method = method}).align(IndexedPoints<D>(map), scan, guess, Outputs::all());
  EXPECT_TRUE(result.pose.is_finite());
  EXPECT_EQ(result.transformed_scan.size(), scan.size());
  EXPECT_EQ(result.matches.size(), scan.size());
  EXPECT_FALSE(result.brief().empty());
  return result;
}

template <int D>
void expect_the_guess(const PointCloud<D>& map, const PointCloud<D>& scan, Stop stop) {
  const Pose<D> guess = test::Random(1).pose<D>(0.1, 0.1);
  for (const Method method : methods) {
    const IcpResult<D> result = match<D>(map, scan, guess, method);
    EXPECT_STREQ(to_string(result.stop), to_string(stop));
    EXPECT_FALSE(result.usable());
    EXPECT_LT(distance(result.pose, guess).translation, 1e-12);
    EXPECT_LT(distance(result.pose, guess).rotation, 1e-12);
  }
}

template <int D>
void expect_too_few() {
  const PointCloud<D> map = test::sharp_shape<D>();
  for (std::size_t count = 0; count <= D; ++count)
    expect_the_guess<D>(map, PointCloud<D>(map.begin(), map.begin() + static_cast<long>(count)), Stop::too_few_points);
  expect_the_guess<D>(map, PointCloud<D>(100, Point<D>::Constant(nan)), Stop::too_few_points);
  expect_the_guess<D>(map, PointCloud<D>(100, Point<D>::Constant(infinity)), Stop::too_few_points);
}

TEST(IcpHardInputTest, TooFewUsablePointsLeaveTheGuess) {
  expect_too_few<2>();
  expect_too_few<3>();
}

template <int D>
void expect_no_overlap() {
  const PointCloud<D> shape = test::sharp_shape<D>();
  PointCloud<D> far = shape;
  for (Point<D>& point : far) point[0] += 50.0;
  expect_the_guess<D>(shape, far, Stop::no_overlap);
  expect_the_guess<D>({}, shape, Stop::no_overlap);
  expect_the_guess<D>(PointCloud<D>(9, Point<D>::Constant(nan)), shape, Stop::no_overlap);
  expect_the_guess<D>(shape, PointCloud<D>(50, Point<D>::Constant(1e200)), Stop::no_overlap);
  expect_the_guess<D>(PointCloud<D>(50, Point<D>::Constant(-1e300)), PointCloud<D>(50, Point<D>::Constant(1e300)),
                      Stop::no_overlap);
}

TEST(IcpHardInputTest, NothingNearLeavesTheGuess) {
  expect_no_overlap<2>();
  expect_no_overlap<3>();
}

TEST(IcpHardInputTest, WithoutOverlapEveryUsablePointIsAnOutlier) {
  const PointCloud2 shape = test::sharp_shape<2>();
  PointCloud2 far = test::transformed(Pose2{80, 0, 0}, shape);
  far[3].x() = nan;
  const IcpResult2 result = match<2>(shape, far, {}, Method::point_to_line);
  EXPECT_EQ(result.outlier_indices.size(), far.size() - 1);
  EXPECT_EQ(result.inliers, 0U);
  EXPECT_EQ(result.mean_inlier_distance, 0.0);
}

TEST(IcpHardInputTest, BadPointsAmongGoodOnesTakeNoPart) {
  const PointCloud2 shape = test::sharp_shape<2>();
  const Pose2 truth{0.2, 0.1, 0.3};
  PointCloud2 scan = test::transformed(truth.inverse(), shape);
  const IcpResult2 clean = match<2>(shape, scan, {0.21, 0.09, 0.31}, Method::point_to_line);
  for (const Point2& bad : {Point2(nan, nan), Point2(0, infinity), Point2(-infinity, nan), Point2(1e300, -1e300)})
    scan.insert(scan.begin() + 40, bad);
  PointCloud2 map = shape;
  map.insert(map.begin() + 10, {Point2(nan, 0), Point2(infinity, -infinity)});
  const IcpResult2 result = match<2>(map, scan, {0.21, 0.09, 0.31}, Method::point_to_line);
  EXPECT_NEAR(result.pose.x, clean.pose.x, 1e-6);
  EXPECT_NEAR(result.pose.theta, clean.pose.theta, 1e-6);
  EXPECT_EQ(result.inliers, clean.inliers);
  EXPECT_EQ(result.outlier_indices, std::vector<int>{40}) << "the one at 1e300 m is a point, and far from the map";
}

TEST(IcpHardInputTest, ASingleStraightWallIsDegenerateAndThePoseKeepsTheGuessAlongIt) {
  const Pose2 T_map_wall{3.0, 2.0, 0.6};
  const PointCloud2 map = test::transformed(T_map_wall, wall({-6, 0}, {6, 0}, 0.01));
  const Pose2 truth{2.5, 3.0, 0.1};
  const PointCloud2 scan = test::transformed(truth.inverse() * T_map_wall, wall({-1.503, 0}, {1.507, 0}, 0.013));
  const Pose2 guess = T_map_wall * Pose2{0.08, 0.05, 0.01} * T_map_wall.inverse() * truth;
  const IcpResult2 result = match<2>(map, scan, guess, Method::point_to_line);
  EXPECT_EQ(result.stop, Stop::degenerate);
  EXPECT_FALSE(result.usable());
  const Point2 off = (T_map_wall.inverse() * result.pose).translation() - (T_map_wall.inverse() * truth).translation();
  const Point2 guessed = (T_map_wall.inverse() * guess).translation() - (T_map_wall.inverse() * truth).translation();
  EXPECT_NEAR(off.y(), 0.0, 1e-6) << "the wall holds this direction";
  EXPECT_NEAR(result.pose.theta, truth.theta, 1e-6);
  EXPECT_NEAR(off.x(), guessed.x(), 1e-3) << "and does not hold this one";
}

TEST(IcpHardInputTest, ASinglePlaneInSpaceIsDegenerate) {
  PointCloud3 plane;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) plane.emplace_back(0.05 * i - 1.0, 0.05 * j - 1.0, 0.3);
  Pose3 guess;
  guess.position = {0.04, -0.03, 0.08};
  const IcpResult3 result = match<3>(plane, plane, guess, Method::point_to_plane);
  EXPECT_EQ(result.stop, Stop::degenerate);
  EXPECT_NEAR(result.pose.position.z(), 0.0, 1e-6);
  EXPECT_NEAR(result.pose.position.x(), 0.04, 1e-6);
  EXPECT_NEAR(result.pose.position.y(), -0.03, 1e-6);
}

TEST(IcpHardInputTest, ARoundRoomDoesNotHoldTheHeading) {
  PointCloud2 circle;
  for (int k = 0; k < 2000; ++k)
    circle.emplace_back(2.0 * std::cos(0.001 * test::pi * k), 2.0 * std::sin(0.001 * test::pi * k));
  const IcpResult2 result = match<2>(circle, circle, {0.05, 0.03, 0.2}, Method::point_to_line);
  EXPECT_EQ(result.stop, Stop::degenerate);
  EXPECT_LT(result.pose.translation().norm(), 1e-4);
  EXPECT_NEAR(result.pose.theta, 0.2, 0.01);
}

TEST(IcpHardInputTest, AllPointsEqualOrInALineGiveAStopReasonAndANumber) {
  const PointCloud2 shape = test::sharp_shape<2>();
  for (const Method method : methods) {
    EXPECT_FALSE(match<2>(shape, PointCloud2(50, shape[7]), {0.01, 0, 0}, method).usable());
    match<2>(PointCloud2(50, Point2(1, 1)), PointCloud2(50, Point2(1, 1)), {0.01, 0, 0}, method);
    match<2>(PointCloud2(50, Point2(1, 1)), shape, {}, method);
    match<2>(PointCloud2{{1, 1}}, shape, {}, method);
    match<2>(PointCloud2{{1, 1}, {2, 2}}, shape, {}, method);
    match<2>(wall({0, 0}, {1, 0}, 0.1), wall({0, 0}, {0, 1}, 0.1), {}, method);

    PointCloud3 line;
    for (int k = 0; k < 60; ++k) line.emplace_back(0.01 * k, 0.02 * k, -0.01 * k);
    const Pose3 guess = Pose3::exp(Pose3::Tangent(0.001, 0.002, 0, 0.01, 0, 0));
    EXPECT_FALSE(match<3>(line, line, guess, method).usable()) << "a line in space does not hold the turn about it";
    EXPECT_FALSE(match<3>(test::sharp_shape<3>(), PointCloud3(50, test::sharp_shape<3>()[5]), guess, method).usable());
  }
}

TEST(IcpHardInputTest, PairsThatTheKernelThrowsAwayDoNotPassForConvergence) {
  // Tukey's weight is zero beyond its scale: 0.1 m off everything is thrown away.
  PointCloud2 map = wall({0, 0}, {4, 0}, 0.01);
  test::append(map, wall({0, 0}, {0, 3}, 0.01));
  PointCloud2 scan = wall({0.5, 0}, {3.5, 0}, 0.01);
  test::append(scan, wall({0, 0.5}, {0, 2.5}, 0.01));
  for (const Method method : methods) {
    const IcpOptions options{.method = method, .kernel = RobustKernel::tukey, .kernel_scale = 0.02};
    const IcpResult2 result = Icp<2>(options).align(IndexedPoints<2>(map), scan, {0.1, 0.1, 0.0});
    EXPECT_EQ(result.stop, Stop::no_overlap);
    EXPECT_EQ(result.pairs, 0U);
  }
}

TEST(IcpHardInputTest, AnglesLeaveInTheHalfOpenTurnEvenWhereThePoseIsTheGuess) {
  const Pose2 guess{1, 2, 0.1 + 4.0 * test::pi};
  EXPECT_NEAR(match<2>(test::sharp_shape<2>(), {}, guess, Method::point_to_line).pose.theta, 0.1, 1e-12);
  EXPECT_NEAR(match<2>({}, test::sharp_shape<2>(), guess, Method::point_to_line).pose.theta, 0.1, 1e-12);
}

TEST(IcpHardInputTest, AGuessThatIsNoNumberIsRefused) {
  Icp<2> icp;
  const IndexedPoints<2> map(test::sharp_shape<2>());
  for (const Pose2& guess : {Pose2{nan, 0, 0}, Pose2{0, infinity, 0}, Pose2{0, 0, nan}}) {
    try {
      icp.align(map, map.points(), guess);
      ADD_FAILURE() << "taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "Icp::align");
      EXPECT_FALSE(error.mend().empty());
    }
  }
  Pose3 guess;
  guess.orientation.w() = nan;
  EXPECT_THROW(Icp<3>().align(IndexedPoints<3>(test::sharp_shape<3>()), {}, guess), Error);
  EXPECT_EQ(icp.align(map, map.points(), {}).stop, Stop::converged) << "it goes on working";
}

TEST(IcpHardInputTest, AMapWithoutTheSurfacesNeededIsRefused) {
  const IndexedPoints<2> bare(test::sharp_shape<2>(), {.neighbours = 0});
  EXPECT_THROW(Icp<2>().align(bare, bare.points(), {}), Error);
  EXPECT_EQ(Icp<2>({.method = Method::point_to_point}).align(bare, bare.points(), {}).stop, Stop::converged);
}

}  // namespace
}  // namespace slamicp::icp_hard_input_test
