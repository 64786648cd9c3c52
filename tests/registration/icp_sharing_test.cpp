// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <thread>

#include <slamicp/registration/icp.hpp>

#include "support/clouds.hpp"

namespace slamicp::icp_sharing_test {
namespace {

using test::Random;

struct Scene {
  IndexedPoints<2> map;
  std::vector<PointCloud2> scans;
  std::vector<Pose2> guesses;

  Scene() {
    Random random(11);
    PointCloud2 cloud = test::sharp_shape<2>();
    for (Point2& point : cloud) point += random.point<2>(0.01);
    map = IndexedPoints<2>(cloud);
    for (int k = 0; k < 30; ++k) {
      const Pose2 truth = random.pose<2>(0.5, 1.0);
      scans.push_back(test::transformed(truth.inverse(), test::sharp_shape<2>()));
      scans.back().resize(static_cast<std::size_t>(random.integer(50, 600)));
      for (Point2& point : scans.back()) point += random.point<2>(0.01);
      guesses.push_back(truth * random.pose<2>(0.1, 0.05));
    }
  }

  std::vector<IcpResult2> run() const {
    Icp<2> icp;
    std::vector<IcpResult2> results;
    for (std::size_t k = 0; k < scans.size(); ++k)
      results.push_back(icp.align(map, scans[k], guesses[k], Outputs::all()));
    return results;
  }
};

void expect_same_bits(const std::vector<IcpResult2>& a, const std::vector<IcpResult2>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].pose.x, b[k].pose.x);
    EXPECT_EQ(a[k].pose.y, b[k].pose.y);
    EXPECT_EQ(a[k].pose.theta, b[k].pose.theta);
    EXPECT_EQ(a[k].stop, b[k].stop);
    EXPECT_EQ(a[k].iterations, b[k].iterations);
    EXPECT_EQ(a[k].mean_inlier_distance, b[k].mean_inlier_distance);
    EXPECT_EQ(a[k].outlier_indices, b[k].outlier_indices);
    EXPECT_EQ(a[k].transformed_scan, b[k].transformed_scan);
    EXPECT_EQ(a[k].searches, b[k].searches);
  }
}

TEST(IcpSharingTest, TheSameInputGivesTheSameBitsWhateverCameBefore) {
  const Scene scene;
  const std::vector<IcpResult2> results = scene.run();
  expect_same_bits(results, scene.run());
  for (std::size_t k = 0; k < scene.scans.size(); ++k)
    expect_same_bits({results[k]}, {Icp<2>().align(scene.map, scene.scans[k], scene.guesses[k], Outputs::all())});
}

TEST(IcpSharingTest, TwoThreadsShareAMap) {
  const Scene scene;
  const std::vector<IcpResult2> alone = scene.run();
  std::vector<IcpResult2> one;
  std::vector<IcpResult2> other;
  {
    std::jthread first([&] { one = scene.run(); });
    std::jthread second([&] { other = scene.run(); });
  }
  expect_same_bits(alone, one);
  expect_same_bits(alone, other);
}

TEST(IcpSharingTest, AnIcpCanBeMoved) {
  const Scene scene;
  Icp<2> icp;
  icp.align(scene.map, scene.scans[0], scene.guesses[0]);
  Icp<2> moved = std::move(icp);
  EXPECT_GT(moved.result().iterations, 0);
  expect_same_bits({moved.align(scene.map, scene.scans[1], scene.guesses[1])},
                   {Icp<2>().align(scene.map, scene.scans[1], scene.guesses[1])});
}

}  // namespace
}  // namespace slamicp::icp_sharing_test
