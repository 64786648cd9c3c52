// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <set>

#include <slamicp/error.hpp>
#include <slamicp/registration/icp.hpp>

#include "support/clouds.hpp"

namespace slamicp::instruction_set_test {
namespace {

constexpr InstructionSet all[] = {InstructionSet::best, InstructionSet::scalar, InstructionSet::portable,
                                  InstructionSet::sse4, InstructionSet::avx2,   InstructionSet::avx512,
                                  InstructionSet::neon};

TEST(InstructionSetTest, OneThatIsNotThereIsRefusedByItsName) {
  int refused = 0;
  for (const InstructionSet set : all) {
    const IcpOptions options{.instruction_set = set};
    if (is_available(set)) {
      EXPECT_EQ(options.problem(), "") << to_string(set);
      EXPECT_NO_THROW(Icp<2>{options}) << to_string(set);
      continue;
    }
    ++refused;
    EXPECT_EQ(options.problem().rfind("instruction_set " + std::string(to_string(set)), 0), 0U) << options.problem();
    EXPECT_NE(options.problem().find("best"), std::string::npos) << "a mend: " << options.problem();
    EXPECT_THROW(Icp<2>{options}, Error) << to_string(set);
  }
  EXPECT_GT(refused, 0) << "no machine has both SSE and NEON";
}

TEST(InstructionSetTest, NoMachineHasThoseOfAnother) {
  EXPECT_TRUE(is_available(InstructionSet::best));
  EXPECT_TRUE(is_available(InstructionSet::scalar));
#if defined(__x86_64__)
  EXPECT_FALSE(is_available(InstructionSet::neon));
#elif defined(__aarch64__)
  EXPECT_FALSE(is_available(InstructionSet::sse4));
  EXPECT_FALSE(is_available(InstructionSet::avx2));
  EXPECT_FALSE(is_available(InstructionSet::avx512));
#endif
  if (is_available(InstructionSet::avx512)) {
    EXPECT_TRUE(is_available(InstructionSet::avx2));
  }
  if (is_available(InstructionSet::avx2)) {
    EXPECT_TRUE(is_available(InstructionSet::sse4));
  }
}

TEST(InstructionSetTest, BestIsOneOfThoseThereAndWhatTheDefaultDoes) {
  const InstructionSet best = best_instruction_set();
  EXPECT_NE(best, InstructionSet::best);
  EXPECT_TRUE(is_available(best));
  const PointCloud2 map = test::sharp_shape<2>();
  const Pose2 truth{0.1, -0.05, 0.2};
  const PointCloud2 scan = test::transformed(truth.inverse(), map);
  const IndexedPoints<2> index(map);
  const IcpResult2 by_default = Icp<2>().align(index, scan, {});
  const IcpResult2 by_name = Icp<2>({.instruction_set = best}).align(index, scan, {});
  EXPECT_EQ(by_default.pose.x, by_name.pose.x);
  EXPECT_EQ(by_default.pose.y, by_name.pose.y);
  EXPECT_EQ(by_default.pose.theta, by_name.pose.theta);
}

TEST(InstructionSetTest, NamesAreDistinct) {
  std::set<std::string> names;
  for (const InstructionSet set : all) names.insert(to_string(set));
  EXPECT_EQ(names.size(), std::size(all));
  EXPECT_EQ(names.count("unknown"), 0U);
}

TEST(InstructionSetTest, CoarseToFineComesToTheSamePose) {
  // What it saves are points looked at, not accuracy.
  test::Random random(3);
  for (int k = 0; k < 20; ++k) {
    PointCloud2 map = test::sharp_shape<2>();
    for (Point2& point : map) point += random.point<2>(0.005);
    const IndexedPoints<2> index(map);
    const Pose2 truth = random.pose<2>(0.3, 0.5);
    const PointCloud2 scan = test::transformed(truth.inverse(), test::sharp_shape<2>());
    const Pose2 guess = truth * random.pose<2>(0.1, 0.05);
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::best}) {
      const IcpResult2 coarse = Icp<2>({.instruction_set = set}).align(index, scan, guess);
      const IcpResult2 full = Icp<2>({.coarse_to_fine = false, .instruction_set = set}).align(index, scan, guess);
      EXPECT_EQ(coarse.stop, Stop::converged);
      EXPECT_EQ(full.stop, Stop::converged);
      EXPECT_LT(distance(coarse.pose, full.pose).translation, 1e-3);
      EXPECT_LT(distance(coarse.pose, full.pose).rotation, 1e-3);
      EXPECT_GT(coarse.pairs, scan.size() * 9 / 10) << "the last step looks at all points";
    }
    const IcpResult2 first = Icp<2>({.max_iterations = 1}).align(index, scan, guess);
    EXPECT_LT(first.pairs, scan.size() / 3) << "the first does not";
    EXPECT_GT(first.pairs, scan.size() / 20);
    // Small scans are always looked at in full.
    const PointCloud2 small(scan.begin(), scan.begin() + 199);
    EXPECT_GT(Icp<2>({.max_iterations = 1}).align(index, small, guess).pairs, 150U);
  }
}

}  // namespace
}  // namespace slamicp::instruction_set_test
