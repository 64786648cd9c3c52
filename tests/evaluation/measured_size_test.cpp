// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/evaluation/measured_size.hpp>
#include <slamicp/simulation/random.hpp>

namespace slamicp::measured_size_test {
namespace {

PointCloud2 arc(const Point2& centre, double radius, double angle, double noise, std::size_t count) {
  Random random(5);
  PointCloud2 points;
  for (std::size_t k = 0; k < count; ++k) {
    const double at = angle * static_cast<double>(k) / static_cast<double>(count);
    points.push_back(centre + (radius + noise * random.normal()) * Point2(std::cos(at), std::sin(at)));
  }
  return points;
}

TEST(FitCircle, FindsACircleFromHalfOfIt) {
  const auto exact = fit_circle(arc({1.0, -2.0}, 0.135, std::numbers::pi, 0.0, 20));
  ASSERT_TRUE(exact);
  EXPECT_NEAR(exact->radius, 0.135, 1e-6);
  EXPECT_NEAR((exact->centre - Point2(1.0, -2.0)).norm(), 0.0, 1e-6);
  const auto noisy = fit_circle(arc({1.0, -2.0}, 0.135, std::numbers::pi, 0.01, 2000));
  ASSERT_TRUE(noisy);
  EXPECT_NEAR(noisy->radius, 0.135, 0.003);
}

TEST(FitCircle, FindsNoneWhereNothingBends) {
  EXPECT_FALSE(fit_circle(PointCloud2{{0.0, 0.0}, {1.0, 0.0}}));
  PointCloud2 line;
  for (int k = 0; k < 10; ++k) line.emplace_back(0.1 * k, 0.0);
  EXPECT_FALSE(fit_circle(line));
}

TEST(MeasuredThing, IsTheReconstructionNearestToTheObstacle) {
  PlacedObstacle placed{"B", {}, {{{1.0, -2.0}, 0.135}}};
  PointCloud2 outliers = arc({1.0, -2.0}, 0.135, 2.0 * std::numbers::pi, 0.003, 400);
  const PointCloud2 other = arc({4.0, 0.0}, 0.3, 2.0 * std::numbers::pi, 0.003, 800);
  outliers.insert(outliers.end(), other.begin(), other.end());
  const auto thing = measured_thing(outliers, placed);
  ASSERT_TRUE(thing);
  EXPECT_NEAR(thing->box.width, 0.27, 0.02);
  EXPECT_NEAR(thing->box.depth, 0.27, 0.02);
  ASSERT_TRUE(thing->round);
  EXPECT_NEAR(thing->round->radius, 0.135, 0.003);
  EXPECT_GT(thing->points.size(), 350U);
  placed.cylinders.front().centre = {-3.0, 0.0};
  EXPECT_FALSE(measured_thing(outliers, placed));
  EXPECT_FALSE(measured_thing({}, placed));
}

}  // namespace
}  // namespace slamicp::measured_size_test
