// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include <slamicp/error.hpp>

namespace slamicp::io_test {

/// A fresh folder that goes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<int> count{0};
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            ("slamicp_" + std::string(test->test_suite_name()) + "_" + test->name() + "_" + std::to_string(++count));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::size_t file_count() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
    return count;
  }

 private:
  std::filesystem::path path_;
};

inline void put(const std::filesystem::path& path, std::string_view content) {
  std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

inline std::string get(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Where the real data are; empty if they are not.
inline std::filesystem::path data_file(const std::string& name) {
  const char* folder = std::getenv("SLAMICP_DATA_DIR");
  const std::filesystem::path path = std::filesystem::path(folder != nullptr ? folder : SLAMICP_DATA_DIR) / name;
  return std::filesystem::exists(path) ? path : std::filesystem::path();
}

/// Runs `action`, which must throw an Error at `where` that says `what` and how to mend it.
template <class Action>
void expect_error(Action&& action, std::string_view where, std::string_view what) {
  try {
    action();
    ADD_FAILURE() << "no Error; wanted '" << what << "' at " << where;
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), where) << error.what();
    EXPECT_NE(error.problem().find(what), std::string::npos) << error.what();
    const bool is_option = where.ends_with("Options");  // there the broken rule says how to mend it
    EXPECT_TRUE(is_option || !error.mend().empty()) << error.what();
  }
}

}  // namespace slamicp::io_test

#define SLAMICP_NEEDS_DATA(variable, name)                                  \
  const std::filesystem::path variable = slamicp::io_test::data_file(name); \
  if (variable.empty()) GTEST_SKIP() << "skipped: no data"
