// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include <slamicp/evaluation/relation_error.hpp>
#include <slamicp/io/relations_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/mapper.hpp>

namespace slamicp::mapper_data_test {
namespace {

struct Benchmark {
  const char* log;
  double published_scan_matching;  // mean translational relation error [m], Kuemmerle et al. 2009
};

class SlamBenchmarkMapping : public testing::TestWithParam<Benchmark> {};

TEST_P(SlamBenchmarkMapping, IsAtLeastAsGoodAsPublishedScanMatching) {
  const char* named = std::getenv("SLAMICP_DATA_DIR");
  const std::filesystem::path folder = std::filesystem::path(named ? named : SLAMICP_DATA_DIR) / "slam_benchmark";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no data";
  const std::string log = GetParam().log;
  Mapper mapper;
  for (const LaserScan& scan : open_scan_log(folder / (log + ".clf"))) mapper.add(scan);
  const RelationError error = relation_error(mapper.trajectory(), load_relations(folder / (log + ".relations")));
  EXPECT_EQ(error.not_found, 0U);
  EXPECT_LE(error.all.translation.mean, GetParam().published_scan_matching) << error.brief();
}

INSTANTIATE_TEST_SUITE_P(Logs, SlamBenchmarkMapping,
                         testing::Values(Benchmark{"intel", 0.220}, Benchmark{"fr079", 0.258}),
                         [](const auto& log) { return std::string(log.param.log); });

}  // namespace
}  // namespace slamicp::mapper_data_test
