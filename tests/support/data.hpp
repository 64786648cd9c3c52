// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

namespace slamicp::test {

/// Where the real data lie: SLAMICP_DATA_DIR of the environment, or the folder that the build was told.
inline std::filesystem::path data_dir() {
  const char* chosen = std::getenv("SLAMICP_DATA_DIR");
  return chosen != nullptr ? chosen : SLAMICP_DATA_DIR;
}

/// The base of tests that need real data: they are skipped where there are none.
class DataTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(data_dir())) GTEST_SKIP() << "skipped: no data";
  }
};

/// Rows of numbers between commas or blanks; lines that begin with a letter are left out.
inline std::vector<std::vector<double>> read_numbers(const std::filesystem::path& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in) << file;
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) != 0) continue;
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream numbers(line);
    rows.emplace_back();
    for (double number = 0.0; numbers >> number;) rows.back().push_back(number);
  }
  return rows;
}

}  // namespace slamicp::test
