// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <gtest/gtest.h>
#include <mutex>
#include <thread>

#include <slamicp/registration/icp.hpp>

#include "support/brute_force.hpp"
#include "support/room.hpp"

namespace slamicp::icp_snapshots_test {
namespace {

using test::Random;

constexpr std::size_t batch_size = 100;
constexpr std::size_t batches = 25;

/// Map points by number: those of a room, then new ones wherever somebody put something.
struct Growth {
  PointCloud2 points = test::simple_room().map(0.02);
  std::size_t at_first = points.size();

  Growth() {
    Random random(17);
    while (points.size() < at_first + batches * batch_size) points.push_back(Point2(3.0, 2.0) + random.point<2>(1.9));
  }

  PointView<2> first(std::size_t count) const { return PointView<2>(points).first(count); }
  PointView<2> batch(std::size_t k) const {
    return PointView<2>(points).subspan(at_first + k * batch_size, batch_size);
  }
};

/// The latest version of a map, as a robot's threads share it.
class Latest {
 public:
  using Pointer = std::shared_ptr<const IndexedPoints<2>>;

  explicit Latest(Pointer map) : map_(std::move(map)) {}
  Pointer get() const {
    const std::scoped_lock lock(mutex_);
    return map_;
  }
  void publish(Pointer map) {
    const std::scoped_lock lock(mutex_);
    map_ = std::move(map);
  }

 private:
  mutable std::mutex mutex_;
  Pointer map_;
};

/// A match, and all that it had to do with.
struct Seen {
  Latest::Pointer map;
  std::size_t scan;
  Pose2 pose;
  Stop stop;
  std::vector<int> outliers;
};

struct Scans {
  std::vector<PointCloud2> scans;
  std::vector<Pose2> guesses;

  Scans() {
    Random random(23);
    const test::Room room = test::simple_room();
    for (int k = 0; k < 8; ++k) {
      const Pose2 pose{random.uniform(1.0, 3.0), random.uniform(1.0, 3.0), random.uniform(-3.0, 3.0)};
      PointCloud2 scan;
      for (int i = 0; i < 300; ++i) {
        const double angle = 2.0 * test::pi * i / 300.0;
        const double range = room.range(pose, angle) * (random.chance(0.2) ? random.uniform(0.2, 1.0) : 1.0);
        scan.emplace_back(range * std::cos(angle), range * std::sin(angle));
      }
      scans.push_back(scan);
      guesses.push_back(pose * random.pose<2>(0.05, 0.03));
    }
  }

  const IcpResult2& align(Icp<2>& icp, const IndexedPoints<2>& map, std::size_t k) const {
    return icp.align(map, scans[k], guesses[k], {.outlier_indices = true});
  }
};

/// What a version of the map must be: so many batches, and each point where it was put.
void expect_whole(const IndexedPoints<2>& map, const Growth& growth) {
  ASSERT_GE(map.size(), growth.at_first);
  ASSERT_EQ((map.size() - growth.at_first) % batch_size, 0U);
  ASSERT_EQ(map.points().size(), map.size());
  ASSERT_TRUE(std::equal(map.points().begin(), map.points().end(), growth.first(map.size()).begin()));
}

/// One thread puts things into the map, one builds its cells, this one localizes. Returns what it saw.
std::vector<Seen> run(Latest& latest, const Growth& growth, const Scans& scans) {
  std::vector<Seen> seen;
  std::atomic<bool> is_grown{false};
  std::atomic<std::size_t> matches{0};
  std::jthread inserter([&] {
    for (std::size_t k = 0; k < batches; ++k) {
      latest.publish(std::make_shared<const IndexedPoints<2>>(latest.get()->with_added(growth.batch(k))));
      for (const std::size_t before = matches; matches < before + 2;) std::this_thread::yield();  // one with this map
    }
    is_grown = true;
  });
  std::jthread builder([&] {
    for (bool is_done = false; !is_done;) {
      const bool was_grown = is_grown;
      is_done = latest.get()->cells().build(2, {3.0, 2.0}) == 0 && was_grown;
    }
  });
  Icp<2> icp;
  for (std::size_t k = 0; !is_grown || k < scans.scans.size(); ++k) {
    const Latest::Pointer map = latest.get();
    expect_whole(*map, growth);
    const IcpResult2& result = scans.align(icp, *map, k % scans.scans.size());
    seen.push_back({map, k % scans.scans.size(), result.pose, result.stop, result.outlier_indices});
    ++matches;
  }
  return seen;
}

std::size_t versions_in(const std::vector<Seen>& seen) {
  std::size_t versions = 1;
  for (std::size_t k = 1; k < seen.size(); ++k) versions += seen[k].map != seen[k - 1].map ? 1U : 0U;
  return versions;
}

TEST(IcpSnapshotsTest, AMatchIsThatOfItsVersionWhateverOthersDo) {
  const Growth growth;
  const Scans scans;
  Latest latest(std::make_shared<const IndexedPoints<2>>(to_cloud(growth.first(growth.at_first))));
  const std::vector<Seen> seen = run(latest, growth, scans);
  EXPECT_EQ(latest.get()->size(), growth.points.size());
  EXPECT_GE(versions_in(seen), batches);
  for (const Seen& one : seen) {
    Icp<2> icp;
    const IcpResult2& again = scans.align(icp, *one.map, one.scan);
    ASSERT_EQ(one.pose.x, again.pose.x);
    ASSERT_EQ(one.pose.y, again.pose.y);
    ASSERT_EQ(one.pose.theta, again.pose.theta);
    ASSERT_EQ(one.stop, again.stop);
    ASSERT_EQ(one.outliers, again.outlier_indices);
    ASSERT_NO_FATAL_FAILURE(expect_whole(*one.map, growth));
  }
}

TEST(IcpSnapshotsTest, AMapIsBuiltBesideTheMatch) {
  const Growth growth;
  const Scans scans;
  Latest latest(std::make_shared<const IndexedPoints<2>>(to_cloud(growth.first(growth.at_first)), SurfaceOptions{},
                                                         CellOptions{.eager = false}));
  const std::vector<Seen> seen = run(latest, growth, scans);
  for (std::size_t k = 0; k < seen.size(); k += 1 + seen.size() / 100) {
    // Built or not, the outliers are exact at the pose.
    const Seen& one = seen[k];
    const PointCloud2 map = to_cloud(one.map->points());
    std::vector<int> outliers;
    for (std::size_t i = 0; i < scans.scans[one.scan].size(); ++i)
      if (!test::nearest_of_all<2>(map, one.pose * scans.scans[one.scan][i], 0.3).found())
        outliers.push_back(static_cast<int>(i));
    ASSERT_EQ(one.outliers, outliers);
    ASSERT_NO_FATAL_FAILURE(expect_whole(*one.map, growth));
  }
  EXPECT_EQ(latest.get()->cells().build(1, {0.0, 0.0}), 0U);
}

TEST(IcpSnapshotsTest, LinesAreThoseOfTheWholeMapThoughBuiltWhileItGrew) {
  // The tiles around what is added are built while it is added: each round a little earlier or later.
  const Growth growth;
  const IndexedPoints<2> at_once(to_cloud(growth.first(growth.at_first + batch_size)));
  for (int round = 0; round < 60; round += test::one_in) {
    const IndexedPoints<2> lazy(to_cloud(growth.first(growth.at_first)), {}, {.eager = false});
    std::atomic<bool> has_begun{false};
    IndexedPoints<2> grown;
    {
      std::jthread builder([&] {
        has_begun = true;
        while (lazy.cells().build(1, {3.0, 2.0}) > 0) continue;
      });
      while (!has_begun) std::this_thread::yield();
      for (int k = 0; k < round * round; ++k) lazy.nearest({3.0, 2.0}, 0.3);
      grown = lazy.with_added(growth.batch(0));
    }
    while (grown.cells().build(100, {3.0, 2.0}) > 0) continue;
    for (std::size_t k = 0; k < grown.size(); ++k) {
      ASSERT_EQ(grown.surface(k).valid(), at_once.surface(k).valid()) << "round " << round << ", point " << k;
      ASSERT_LT((grown.surface(k).centroid - at_once.surface(k).centroid).norm(), 1e-5)
          << "round " << round << ", point " << k;
    }
  }
}

}  // namespace
}  // namespace slamicp::icp_snapshots_test
