// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/registration/icp.hpp>

#include "support/clouds.hpp"

namespace slamicp::icp_recovery_test {
namespace {

using test::Random;

constexpr Method methods[] = {Method::point_to_point, Method::point_to_line};

template <int D>
void expect_near(const Pose<D>& pose, const Pose<D>& truth, double metres, double radians) {
  EXPECT_LE(distance(pose, truth).translation, metres);
  EXPECT_LE(distance(pose, truth).rotation, radians);
}

/// Map points as the robot sees them at `truth`: those whose surface is flat, so that their line is exact too.
template <int D>
PointCloud<D> clean_scan(const IndexedPoints<D>& map, const Pose<D>& truth) {
  PointCloud<D> scan;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const Surface<D> surface = map.surface(k);
    if (surface.valid() && std::abs(surface.normal.dot(map.points()[k] - surface.centroid)) < 1e-9)
      scan.push_back(truth.inverse() * map.points()[k]);
  }
  return scan;
}

template <int D>
void expect_exact_recovery(Method method, double metres, double radians) {
  const IndexedPoints<D> map(test::sharp_shape<D>());
  Icp<D> icp({.method = method,
              .translation_tolerance = 1e-10,
              .rotation_tolerance = 1e-10,
              .instruction_set = InstructionSet::scalar});
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Pose<D> truth = random.pose<D>(0.5, 0.5);
    const PointCloud<D> scan = clean_scan<D>(map, truth);
    ASSERT_GT(scan.size(), map.size() / 4);
    const IcpResult<D>& result = icp.align(map, scan, truth * random.pose<D>(metres, radians), Outputs::all());
    EXPECT_EQ(result.stop, Stop::converged);
    expect_near<D>(result.pose, truth, 1e-8, 1e-8);
    EXPECT_EQ(result.inliers, scan.size());
    EXPECT_LT(result.mean_inlier_distance, 1e-8);
    EXPECT_EQ(result.searches_for_outputs, 0U) << "no neighbour can have changed";
  }
}

TEST(IcpRecoveryTest, CleanDataGiveTheExactPoseInThePlane) {
  expect_exact_recovery<2>(Method::point_to_point, 0.005, 0.003);
  expect_exact_recovery<2>(Method::point_to_line, 0.08, 0.04);
}

TEST(IcpRecoveryTest, CleanDataGiveTheExactPoseInSpace) {
  expect_exact_recovery<3>(Method::point_to_point, 0.01, 0.01);
  expect_exact_recovery<3>(Method::point_to_plane, 0.08, 0.04);
}

TEST(IcpRecoveryTest, PointToPointComesAsNearAsTheMapsSpacing) {
  // Two lattices of the same spacing can lock into each other a step apart: the method's limit, not a mistake.
  const IndexedPoints<2> map(test::sharp_shape<2>());
  Random random(1);
  const Pose2 truth = random.pose<2>(0.5, 0.5);
  const IcpResult2 result = Icp<2>({.method = Method::point_to_point, .max_iterations = 500})
                                .align(map, clean_scan<2>(map, truth), truth * Pose2{0.07, -0.06, 0.03});
  EXPECT_EQ(result.stop, Stop::converged);
  expect_near<2>(result.pose, truth, 0.02, 0.01);
}

TEST(IcpRecoveryTest, FarFromTheOriginIsAsGood) {
  const Pose2 far{400.0, -300.0, 0.0};
  const IndexedPoints<2> map(test::transformed(far, test::sharp_shape<2>()));
  const Pose2 truth = far * Pose2{0.2, 0.1, 0.3};
  for (const Method method : methods) {
    const IcpResult2 result = Icp<2>({.method = method, .translation_tolerance = 1e-9, .rotation_tolerance = 1e-9})
                                  .align(map, clean_scan<2>(map, truth), truth * Pose2{0.004, -0.003, 0.002});
    expect_near<2>(result.pose, truth, 1e-7, 1e-7);
  }
}

TEST(IcpRecoveryTest, NoiseAveragesOut) {
  Random random(5);
  const PointCloud2 clean = test::sharp_shape<2>();
  PointCloud2 noisy = clean;
  for (Point2& point : noisy) point += Point2(random.normal(0.01), random.normal(0.01));
  const IndexedPoints<2> map(noisy);
  for (const Method method : methods) {
    PointCloud2 scan = test::transformed(Pose2{0.3, 0.2, 0.4}.inverse(), clean);
    for (Point2& point : scan) point += Point2(random.normal(0.01), random.normal(0.01));
    const IcpResult2 result = Icp<2>({.method = method, .max_iterations = 200}).align(map, scan, {0.34, 0.16, 0.42});
    EXPECT_EQ(result.stop, Stop::converged);
    expect_near<2>(result.pose, {0.3, 0.2, 0.4}, 0.003, 0.002);
  }
}

// ------------------------------------------------------------------------------------- single steps

TEST(IcpStepTest, PointToPointIsExactOnThreePairsInOneStep) {
  const PointCloud2 map{{0, 0}, {3, 0}, {0, 2}};
  const Pose2 truth{0.11, -0.08, 0.05};
  const IcpResult2 result =
      Icp<2>({.method = Method::point_to_point, .max_iterations = 1, .instruction_set = InstructionSet::scalar})
          .align(IndexedPoints<2>(map, {.neighbours = 0}), test::transformed(truth.inverse(), map), {});
  EXPECT_EQ(result.iterations, 1);
  expect_near<2>(result.pose, truth, 1e-13, 1e-13);
}

TEST(IcpStepTest, PointToPointIsExactOnFourPairsInAPlaneOfSpaceAndNeverMirrors) {
  const PointCloud3 map{{0, 0, 1}, {3, 0, 1}, {0, 2, 1}, {3, 2.5, 1}};
  Pose3::Tangent motion;
  motion << 0.05, -0.06, 0.04, 0.02, -0.03, 0.03;
  const Pose3 truth = Pose3::exp(motion);
  const IcpResult3 result =
      Icp<3>({.method = Method::point_to_point, .max_iterations = 1})
          .align(IndexedPoints<3>(map, {.neighbours = 0}), test::transformed(truth.inverse(), map), {});
  expect_near<3>(result.pose, truth, 1e-12, 1e-7);
  EXPECT_NEAR(result.pose.rotation().determinant(), 1.0, 1e-12);
}

/// The pairs of a first step: each scan point with its nearest map point, if closer than the gate.
template <int D>
struct Pair {
  Point<D> scan;
  Point<D> map;
  Surface<D> surface;
};
template <int D>
std::vector<Pair<D>> pairs_of(const IndexedPoints<D>& map, const PointCloud<D>& scan, const Pose<D>& guess,
                              double gate) {
  std::vector<Pair<D>> pairs;
  for (const Point<D>& point : scan) {
    const Neighbour nearest = map.nearest(guess * point, gate);
    if (!nearest.found()) continue;
    const auto k = static_cast<std::size_t>(nearest.index);
    if (map.surface(k).valid()) pairs.push_back({point, map.points()[k], map.surface(k)});
  }
  return pairs;
}

template <int D>
void expect_gauss_newton_step(RobustKernel kernel, InstructionSet set, double tolerance) {
  constexpr int n = Pose<D>::degrees_of_freedom;
  Random random(3);
  const IndexedPoints<D> map(test::sharp_shape<D>());
  const Pose<D> truth = random.pose<D>(0.5, 0.5);
  const PointCloud<D> scan = test::transformed(truth.inverse(), test::sharp_shape<D>());
  const Pose<D> guess = truth * random.pose<D>(0.08, 0.05);
  const IcpOptions options{
      .max_iterations = 1, .kernel = kernel, .kernel_scale = 0.04, .coarse_to_fine = false, .instruction_set = set};
  const IcpResult<D> result = Icp<D>(options).align(map, scan, guess);

  // The same step with a jacobian by central differences.
  const std::vector<Pair<D>> pairs = pairs_of<D>(map, scan, guess, options.max_correspondence_distance);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  for (const Pair<D>& pair : pairs) {
    const auto residual = [&](const typename Pose<D>::Tangent& motion) {
      return pair.surface.trust *
             pair.surface.normal.dot(pair.surface.centroid - guess * Pose<D>::exp(motion) * pair.scan);
    };
    Eigen::VectorXd jacobian(n);
    for (int k = 0; k < n; ++k) {
      typename Pose<D>::Tangent motion = Pose<D>::Tangent::Zero();
      motion[k] = 1e-6;
      jacobian[k] = (residual(motion) - residual(-motion)) / 2e-6;
    }
    const double now = residual(Pose<D>::Tangent::Zero());
    const double weight = kernel_weight(kernel, now, options.kernel_scale);
    information += weight * jacobian * jacobian.transpose();
    gradient -= weight * now * jacobian;
  }
  const typename Pose<D>::Tangent motion = information.llt().solve(gradient);
  EXPECT_LE(result.pairs, pairs.size());
  EXPECT_GT(motion.norm(), 0.01);
  expect_near<D>(result.pose, guess * Pose<D>::exp(motion), tolerance, tolerance);
}

template <int D>
void expect_least_squares_step(RobustKernel kernel) {
  constexpr int n = Pose<D>::degrees_of_freedom;
  Random random(4);
  const IndexedPoints<D> map(test::sharp_shape<D>());
  const Pose<D> truth = random.pose<D>(0.5, 0.5);
  const PointCloud<D> scan = test::transformed(truth.inverse(), test::sharp_shape<D>());
  const Pose<D> guess = truth * random.pose<D>(0.08, 0.05);
  const IcpOptions options{.method = Method::point_to_point,
                           .max_iterations = 1,
                           .kernel = kernel,
                           .kernel_scale = 0.04,
                           .coarse_to_fine = false,
                           .instruction_set = InstructionSet::scalar};
  const IcpResult<D> result = Icp<D>(options).align(map, scan, guess);

  // Equation (3), weighted: flat at the step's pose in every direction, by central differences.
  std::vector<double> weights;
  std::vector<std::pair<Point<D>, Point<D>>> pairs;
  for (const Point<D>& point : scan) {
    const Neighbour nearest = map.nearest(guess * point, options.max_correspondence_distance);
    if (!nearest.found()) continue;
    pairs.emplace_back(point, map.points()[static_cast<std::size_t>(nearest.index)]);
    weights.push_back(kernel_weight(kernel, std::sqrt(nearest.squared_distance), options.kernel_scale));
  }
  const auto cost = [&](const Pose<D>& pose) {
    double sum = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      sum += weights[k] * (pose * pairs[k].first - pairs[k].second).squaredNorm();
    return sum;
  };
  ASSERT_GT(pairs.size(), 100U);
  EXPECT_LT(cost(result.pose), cost(guess));
  for (int k = 0; k < n; ++k) {
    typename Pose<D>::Tangent motion = Pose<D>::Tangent::Zero();
    motion[k] = 1e-4;
    const double slope = (cost(result.pose * Pose<D>::exp(motion)) - cost(result.pose * Pose<D>::exp(-motion))) / 2e-4;
    const double at_guess = (cost(guess * Pose<D>::exp(motion)) - cost(guess * Pose<D>::exp(-motion))) / 2e-4;
    EXPECT_LT(std::abs(slope), 1e-6 * (1.0 + std::abs(at_guess)));
  }
}

TEST(IcpStepTest, EveryKernelStepsAsItsFormulaSays) {
  for (const RobustKernel kernel : {RobustKernel::none, RobustKernel::huber, RobustKernel::cauchy,
                                    RobustKernel::geman_mcclure, RobustKernel::tukey}) {
    SCOPED_TRACE("kernel " + std::to_string(static_cast<int>(kernel)));
    expect_gauss_newton_step<2>(kernel, InstructionSet::scalar, 1e-7);
    expect_gauss_newton_step<2>(kernel, InstructionSet::best, 1e-5);
    expect_gauss_newton_step<3>(kernel, InstructionSet::scalar, 1e-7);
    expect_least_squares_step<2>(kernel);
    expect_least_squares_step<3>(kernel);
  }
}

}  // namespace
}  // namespace slamicp::icp_recovery_test
