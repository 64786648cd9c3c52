// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include <slamicp/evaluation/relation_error.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/io/relations_file.hpp>
#include <slamicp/io/scan_log.hpp>

namespace slamicp::relation_error_data_test {
namespace {

std::filesystem::path benchmark_folder() {
  const char* elsewhere = std::getenv("SLAMICP_DATA_DIR");
  return std::filesystem::path(elsewhere != nullptr ? elsewhere : SLAMICP_DATA_DIR) / "slam_benchmark";
}

struct Benchmark {
  const char* name;
  std::size_t scans;
  std::size_t relations;
  std::size_t long_relations;
  double translation;  // [m], of the raw odometry: data/MANIFEST.md, whose number is that of the laser's poses
};

class RawOdometry : public testing::TestWithParam<Benchmark> {};

TEST_P(RawOdometry, ScoresAsTheManifestSays) {
  const Benchmark& benchmark = GetParam();
  const std::filesystem::path log_file = benchmark_folder() / (std::string(benchmark.name) + ".clf");
  if (!std::filesystem::exists(log_file)) GTEST_SKIP() << "skipped: no data";

  Trajectory odometry;
  for (const LaserScan& scan : open_scan_log(log_file))
    odometry.push_back({scan.stamp, scan.T_odom_robot.value() * scan.T_robot_laser});
  ASSERT_EQ(odometry.size(), benchmark.scans);
  const RelationError score =
      relation_error(odometry, load_relations(benchmark_folder() / (std::string(benchmark.name) + ".relations")));
  EXPECT_EQ(score.not_found, 0U);
  EXPECT_EQ(score.all.translation.count, benchmark.relations);
  EXPECT_EQ(score.long_spans.translation.count, benchmark.long_relations);
  EXPECT_NEAR(score.all.translation.mean, benchmark.translation, 0.0005) << score.brief();
  RecordProperty("score", score.brief());

  // The log against itself: all stamps are found, backwards and repeated ones too.
  const TrajectoryError itself = absolute_error(odometry, odometry);
  EXPECT_EQ(itself.unmatched, 0U);
  EXPECT_LT(itself.translation.max, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(SlamBenchmark, RawOdometry,
                         testing::Values(Benchmark{"intel", 13631, 2984, 1210, 7.370},
                                         Benchmark{"fr079", 4934, 1685, 577, 6.507}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace slamicp::relation_error_data_test
