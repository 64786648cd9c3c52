// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/registration/icp.hpp>

#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace slamicp::icp_outputs_test {
namespace {

using test::Random;

struct Scene {
  IndexedPoints<2> map{test::sharp_shape<2>()};
  PointCloud2 scan;
  Pose2 guess{0.32, 0.17, 0.42};

  Scene() {
    scan = test::transformed(Pose2{0.3, 0.2, 0.4}.inverse(), to_cloud(map.points()));
    test::append(scan, test::wall({1.0, 0.1}, {1.3, 0.2}, 0.01));
    scan.push_back({test::nan, 1.0});
  }
};

TEST(IcpOutputsTest, EachIsComputedOnlyWhenAskedForAndIsThenTheSame) {
  const Scene scene;
  Icp<2> icp;
  const IcpResult2 all = icp.align(scene.map, scene.scan, scene.guess, Outputs::all());
  ASSERT_FALSE(all.outlier_indices.empty());
  ASSERT_GT(all.inliers, 100U);
  for (int wanted = 0; wanted < 64; ++wanted) {
    SCOPED_TRACE("combination " + std::to_string(wanted));
    const auto asked = [wanted](int bit) { return ((wanted >> bit) & 1) != 0; };
    const Outputs outputs{asked(0), asked(1), asked(2), asked(3), asked(4), asked(5)};
    const IcpResult2& result = icp.align(scene.map, scene.scan, scene.guess, outputs);

    EXPECT_EQ(result.stop, all.stop);
    EXPECT_EQ(result.iterations, all.iterations);
    EXPECT_EQ(result.pose.x, all.pose.x);
    EXPECT_EQ(result.outlier_indices, outputs.outlier_indices ? all.outlier_indices : std::vector<int>{});
    EXPECT_EQ(result.outliers_in_map, outputs.outliers_in_map ? all.outliers_in_map : PointCloud2{});
    EXPECT_EQ(result.updated_map, outputs.updated_map ? all.updated_map : PointCloud2{});
    EXPECT_EQ(result.transformed_scan.size(), outputs.transformed_scan ? scene.scan.size() : 0U);
    EXPECT_EQ(result.matches.size(), outputs.matches ? scene.scan.size() : 0U);
    const bool distances = outputs.mean_inlier_distance || outputs.matches;
    EXPECT_EQ(result.inliers, distances ? all.inliers : 0U);
    EXPECT_EQ(result.mean_inlier_distance, distances ? all.mean_inlier_distance : 0.0);
    EXPECT_TRUE(wanted != 0 || result.searches_for_outputs == 0);
  }
}

TEST(IcpOutputsTest, OutliersAreThoseOfTheFinalPoseNotOfTheLastLinearization) {
  // One step from a guess 0.2 m off: at the guess a whole wall is out, at the final pose nothing but the clutter is.
  const Scene scene;
  const Pose2 guess = Pose2{0.3, 0.2, 0.4} * Pose2{0.15, 0.12, 0.02};
  const IcpOptions options{.max_correspondence_distance = 0.3, .outlier_distance = 0.1, .max_iterations = 1};
  const IcpResult2 result = Icp<2>(options).align(scene.map, scene.scan, guess, Outputs::all());
  const auto outliers_at = [&](const Pose2& pose) {
    std::vector<int> outliers;
    for (std::size_t i = 0; i + 1 < scene.scan.size(); ++i)
      if (!test::nearest_of_all<2>(to_cloud(scene.map.points()), pose * scene.scan[i], 0.1).found())
        outliers.push_back(static_cast<int>(i));
    return outliers;
  };
  EXPECT_EQ(result.outlier_indices, outliers_at(result.pose));
  EXPECT_GT(outliers_at(guess).size(), 3 * outliers_at(result.pose).size());
}

TEST(IcpOutputsTest, SearchesAreMadeOnlyForPointsWhoseNeighbourMayHaveChanged) {
  // After a single step every point was last searched at the guess, so what is certain can be told from outside.
  const PointCloud2 cloud = test::sharp_shape<2>();
  const IndexedPoints<2> map(cloud);
  for (const double off : {1e-12, 1e-4, 1e-3, 1e-2, 0.1}) {
    SCOPED_TRACE("off by " + std::to_string(off));
    const PointCloud2 scan = test::transformed(Pose2{0.3, 0.2, 0.4}.inverse(), cloud);
    const Pose2 guess = Pose2{0.3, 0.2, 0.4} * Pose2{off, -off, 0.5 * off};
    const IcpResult2 result =
        Icp<2>({.max_iterations = 1, .coarse_to_fine = false, .instruction_set = InstructionSet::scalar})
            .align(map, scan, guess, Outputs::all());
    EXPECT_EQ(result.searches, scan.size());
    std::size_t may_have_changed = 0;
    for (const Point2& point : scan) {
      const auto at_guess = test::all_within<2>(cloud, guess * point, 0.33);
      const double second = at_guess.size() > 1 ? std::sqrt(at_guess[1].squared_distance) : 0.33;
      const double moved = (result.pose * point - guess * point).norm();
      ASSERT_FALSE(at_guess.empty());
      const double first = (cloud[static_cast<std::size_t>(at_guess[0].index)] - result.pose * point).norm();
      if (first + moved > second - 1e-8) ++may_have_changed;
    }
    EXPECT_LE(result.searches_for_outputs, may_have_changed);
    EXPECT_EQ(result.searches_for_outputs > 0, off >= 0.01);
  }
}

TEST(IcpOutputsTest, AClassDoesNotDependOnTheOutputsAskedForNotEvenByARounding) {
  // Distances whose square is one bit below the limit's, while their root rounds to the limit itself.
  const double limit = 0.3;
  const double below = std::nextafter(limit * limit, 0.0);
  Random random(1);
  std::vector<Point2> edges{{limit, 0.0}};
  while (edges.size() < 4) {
    const double x = random.uniform(0.0, limit);
    const Point2 point(x, std::sqrt(below - x * x));
    if (point.squaredNorm() == below && std::sqrt(below) == limit) edges.push_back(point);
  }
  const IndexedPoints<2> map(PointCloud2{{0, 0}});
  for (const Point2& edge : edges) {
    const PointCloud2 scan{edge};  // one point: the pose is the guess, exactly
    const IcpResult2 all = Icp<2>().align(map, scan, {}, Outputs::all());
    const IcpResult2 only = Icp<2>().align(map, scan, {}, {.outlier_indices = true});
    EXPECT_EQ(all.outlier_indices, only.outlier_indices);
    EXPECT_EQ(all.outlier_indices.empty(), edge.squaredNorm() < limit * limit);
    EXPECT_NE(is_inlier(all.matches[0].point_class), is_outlier(all.matches[0].point_class));
  }
}

TEST(IcpOutputsTest, AResultIsForgottenByTheNext) {
  const Scene scene;
  Icp<2> icp;
  icp.align(scene.map, scene.scan, scene.guess, Outputs::all());
  const IcpResult2& result = icp.align(scene.map, {}, {1, 2, 0.5}, Outputs::all());
  EXPECT_EQ(result.stop, Stop::too_few_points);
  EXPECT_EQ(result.pose.x, 1.0);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.inliers + result.pairs + result.searches, 0U);
  EXPECT_TRUE(result.outlier_indices.empty() && result.matches.empty() && result.transformed_scan.empty());
  EXPECT_EQ(result.updated_map, to_cloud(scene.map.points()));
}

TEST(IcpOutputsTest, BriefSaysWhyItEndedAndWhatWasFound) {
  const Scene scene;
  const IcpResult2 result = Icp<2>().align(scene.map, scene.scan, scene.guess, Outputs::all());
  for (const char* word : {"converged after ", " iterations at 0.3", " inliers at ", " outliers"})
    EXPECT_NE(result.brief().find(word), std::string::npos) << result.brief();
  EXPECT_STREQ(to_string(Stop::no_overlap), "no_overlap");
}

TEST(IcpOutputsTest, AlignOfTwoCloudsIsAnIcpOverTheirIndex) {
  const Scene scene;
  for (const Method method : {Method::point_to_point, Method::point_to_line}) {
    const IcpResult2 once = align(scene.scan, to_cloud(scene.map.points()), scene.guess, {.method = method});
    const IndexedPoints<2> map(to_cloud(scene.map.points()), SurfaceOptions::sparse(), {.eager = false});
    const IcpResult2 kept = Icp<2>({.method = method}).align(map, scene.scan, scene.guess, Outputs::all());
    EXPECT_EQ(once.pose.x, kept.pose.x);
    EXPECT_EQ(once.pose.theta, kept.pose.theta);
    EXPECT_EQ(once.outlier_indices, kept.outlier_indices);
  }
}

}  // namespace
}  // namespace slamicp::icp_outputs_test
