// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "support/clouds.hpp"

namespace slamicp::indexed_points_test {
namespace {

using test::Random;

template <typename Index>
void expect_exact_reach() {
  const Index index(PointCloud2{{3.0, 4.0}});
  EXPECT_FALSE(index.nearest({0, 0}, 5.0).found());
  EXPECT_FALSE(index.nearest_two({0, 0}, 5.0).nearest.found());
  EXPECT_TRUE(index.nearest({0, 0}, std::nextafter(5.0, 6.0)).found());
  std::vector<Neighbour> found(1);
  EXPECT_EQ(index.nearest_k({0, 0}, 5.0, found), 0U);
  EXPECT_EQ(index.nearest_k({0, 0}, 5.001, found), 1U);
  std::vector<int> within;
  index.within({0, 0}, 5.0, within);
  EXPECT_TRUE(within.empty());
  EXPECT_FALSE(index.nearest({3, 4}, 0.0).found());
}

TEST(ReachTest, APointAtTheReachIsNotFound) {
  expect_exact_reach<KdTree<2>>();
  expect_exact_reach<IndexedPoints<2>>();
}

TEST(ReachTest, OthersAreNeverClaimedBeyondTheReach) {
  const IndexedPoints<2> index(PointCloud2{{0, 0}, {10, 0}});
  EXPECT_EQ(index.nearest_two({0.1, 0}, 2.0).others_squared_distance, 4.0);
  EXPECT_EQ(IndexedPoints<2>().nearest_two({0, 0}, 2.0).others_squared_distance, 4.0);
}

TEST(IndexTest, NoPointsNoAnswersNoCrash) {
  const PointCloud2 none_finite{{test::nan, 0}, {0, test::infinity}};
  for (const IndexedPoints<2>& index : {IndexedPoints<2>(), IndexedPoints<2>(PointCloud2{}),
                                        IndexedPoints<2>(none_finite), IndexedPoints<2>().with_added(none_finite)}) {
    EXPECT_FALSE(index.nearest({0, 0}, 1e9).found());
    EXPECT_EQ(index.nearest_k({0, 0}, 1e9, {}), 0U);
    EXPECT_EQ(index.spacing(), 0.0);
  }
  EXPECT_EQ(IndexedPoints<2>(PointCloud2{{1, 2}}).nearest_k({0, 0}, 1e9, {}), 0U);
}

template <int D>
std::vector<Surface<D>> surfaces_of(const IndexedPoints<D>& index) {
  std::vector<Surface<D>> all;
  for (std::size_t k = 0; k < index.size(); ++k) all.push_back(index.surface(k));
  return all;
}

TEST(IndexTest, AnOlderVersionIsNotTouchedByGrowth) {
  const IndexedPoints<2> old(test::sharp_shape<2>());
  const PointCloud2 points = to_cloud(old.points());
  const auto surfaces = surfaces_of(old);
  const IndexedPoints<2> grown = old.with_added(PointCloud2{{0.0, 0.0}, {0.01, 0.0}});
  EXPECT_EQ(to_cloud(old.points()), points);
  EXPECT_EQ(grown.size(), points.size() + 2);
  EXPECT_EQ(old.nearest({0, 0}, 0.005).index, -1);
  EXPECT_EQ(grown.nearest({0, 0}, 0.005).index, static_cast<int>(points.size()));
  for (std::size_t k = 0; k < surfaces.size(); ++k) EXPECT_EQ(old.surface(k).centroid, surfaces[k].centroid);
}

TEST(IndexTest, SpacingIsTheMedianDistanceToTheNext) {
  EXPECT_NEAR(IndexedPoints<2>(test::wall({0, 0}, {5, 0}, 0.02)).spacing(), 0.02, 1e-9);
  EXPECT_EQ(IndexedPoints<2>(PointCloud2{{1, 1}}).spacing(), 0.0);
  EXPECT_EQ(IndexedPoints<2>(PointCloud2(50, Point2(1, 1))).spacing(), 0.0);
  EXPECT_NEAR(IndexedPoints<2>(PointCloud2{{1, 1}}).with_added(test::wall({0, 0}, {5, 0}, 0.02)).spacing(), 0.02, 1e-9);
}

TEST(SurfaceTest, OfANoisyWallIsTheWall) {
  Random random(1);
  const Pose2 somewhere{300.0, -200.0, 0.6};
  const PointCloud2 points = test::transformed(somewhere, test::wall({0, 0}, {8, 0}, 0.008, 0.01, &random));
  const IndexedPoints<2> index(points, {.neighbours = 20});
  const Vector<2> normal = somewhere.rotation() * Vector<2>(0, 1);
  double sum = 0.0;
  double raw = 0.0;
  for (std::size_t k = 20; k + 20 < points.size(); ++k) {
    const Surface2 surface = index.surface(k);
    ASSERT_TRUE(surface.valid());
    ASSERT_NEAR(surface.normal.norm(), 1.0, 1e-12);
    ASSERT_GT(std::abs(surface.normal.dot(normal)), std::cos(0.3));
    sum += std::abs(normal.dot(surface.centroid - somewhere.translation()));
    raw += std::abs(normal.dot(points[k] - somewhere.translation()));
  }
  EXPECT_LT(sum, raw / 3.0) << "20 neighbours bring the line about sqrt(20) times nearer to the wall";
}

TEST(SurfaceTest, OfAnExactPlaneIsThePlane) {
  const IndexedPoints<3> index(test::sharp_shape<3>());
  const Vector<3> up = Pose3::exp(Pose3::Tangent(-0.5, -0.4, -0.6, 0.2, 0.1, -0.3)).rotation() * Vector<3>(0, 0, 1);
  EXPECT_NEAR(std::abs(index.surface(3 * (10 * 21 + 10)).normal.dot(up)), 1.0, 1e-9);
}

template <int D>
int valid_surfaces_of(const PointCloud<D>& cloud) {
  const auto surfaces = surfaces_of(IndexedPoints<D>(cloud));
  return static_cast<int>(std::count_if(surfaces.begin(), surfaces.end(), [](const auto& one) { return one.valid(); }));
}

TEST(SurfaceTest, IsMissingWhereThereIsNone) {
  const PointCloud2 lonely{{0, 0}, {100, 0}, {200, 0}};
  EXPECT_EQ(valid_surfaces_of<2>(lonely), 0);
  EXPECT_EQ(valid_surfaces_of<2>(PointCloud2(30, Point2(1, 1))), 0);
  EXPECT_EQ(valid_surfaces_of<2>({{test::nan, 0}}), 0);
  PointCloud3 line;
  for (int k = 0; k < 50; ++k) line.emplace_back(0.01 * k, 0.02 * k, 0.0);
  EXPECT_EQ(valid_surfaces_of<3>(line), 0);
  EXPECT_FALSE(IndexedPoints<2>(lonely, {.neighbours = 0}).has_surfaces());
}

template <int D>
void expect_same_surfaces(const std::vector<Surface<D>>& a, const std::vector<Surface<D>>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].valid(), b[k].valid()) << k;
    ASSERT_LE((a[k].centroid - b[k].centroid).norm(), tolerance) << k;
    ASSERT_LE((a[k].normal - b[k].normal).norm(), tolerance) << k;
  }
}

template <int D>
void expect_growth_to_be_as_built_at_once() {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const SurfaceOptions options{.neighbours = random.integer(5, 25), .radius = random.uniform(0.1, 1.0)};
    PointCloud<D> cloud = test::unkind_cloud<D>(random, random.integer(0, 200));
    IndexedPoints<D> grown(cloud, options);
    for (int growth = 0; growth < 6; ++growth) {
      const PointCloud<D> more = test::unkind_cloud<D>(random, random.integer(0, 60));
      grown = grown.with_added(more);
      cloud.insert(cloud.end(), more.begin(), more.end());
    }
    const IndexedPoints<D> at_once(cloud, options);
    ASSERT_NO_FATAL_FAILURE(expect_same_surfaces<D>(surfaces_of(grown), surfaces_of(at_once), 1e-12));
    if constexpr (D == 3) {  // in the plane it is sampled less often
      ASSERT_EQ(grown.spacing(), at_once.spacing());
    }
  }
}

TEST(SurfaceTest, GrownIsAsBuiltAtOnce) {
  expect_growth_to_be_as_built_at_once<2>();
  expect_growth_to_be_as_built_at_once<3>();
}

TEST(SurfaceTest, AnyNumberOfThreadsGivesTheSameBits) {
  Random random(3);
  const PointCloud2 cloud = test::unkind_cloud<2>(random, 4000);
  const IndexedPoints<2> one(cloud, {.threads = 1});
  for (const int threads : {2, 3, 7}) {
    const IndexedPoints<2> many(cloud, {.threads = threads});
    expect_same_surfaces<2>(surfaces_of(one), surfaces_of(many), 0.0);
  }
}

TEST(SurfaceOptionsTest, AbsurdOnesAreRefusedWithAMend) {
  const SurfaceOptions absurd[] = {{.neighbours = -1},    {.neighbours = 65},    {.radius = 0.0},   {.radius = -1.0},
                                   {.radius = test::nan}, {.min_neighbours = 2}, {.neighbours = 4}, {.threads = 0}};
  for (const SurfaceOptions& options : absurd) {
    try {
      const IndexedPoints<2> index(PointCloud2{{0, 0}}, options);
      ADD_FAILURE() << "taken: neighbours " << options.neighbours << ", radius " << options.radius;
    } catch (const Error& error) {
      EXPECT_FALSE(error.problem().empty());
      EXPECT_EQ(error.where(), "SurfaceOptions");
      EXPECT_FALSE(error.mend().empty());
    }
  }
}

}  // namespace
}  // namespace slamicp::indexed_points_test
