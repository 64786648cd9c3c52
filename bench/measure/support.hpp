// SPDX-License-Identifier: Apache-2.0
// What the measurements share: where data are and results go, tables, percentiles.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/io/picture.hpp>

namespace slamicp::measure {

using Json = nlohmann::ordered_json;

/// printf into a string.
[[gnu::format(printf, 1, 2)]] inline std::string text(const char* pattern, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
  va_end(arguments);
  return buffer;
}

/// A file of the data folder, SLAMICP_DATA_DIR. Throws where it is not there.
inline std::filesystem::path data(const std::string& file) {
  const char* folder = std::getenv("SLAMICP_DATA_DIR");
  if (folder == nullptr || *folder == '\0')
    throw std::runtime_error("no data: set SLAMICP_DATA_DIR to their folder; where to get them: see docs/data.md");
  std::filesystem::path path = std::filesystem::path(folder) / file;
  if (!std::filesystem::exists(path))
    throw std::runtime_error("no data: there is no " + path.string() + "; where to get it: see docs/data.md");
  return path;
}

/// A file of the folder for results, SLAMICP_OUT; empty where none is set.
inline std::filesystem::path out(const std::string& file) {
  const char* folder = std::getenv("SLAMICP_OUT");
  if (folder == nullptr || *folder == '\0') return {};
  std::filesystem::create_directories(folder);
  return std::filesystem::path(folder) / file;
}

/// Keeps the results as SLAMICP_OUT/name.json, where that is set.
inline void save_results(const std::string& name, const Json& results) {
  if (const auto path = out(name + ".json"); !path.empty()) write_file(path, results.dump(2) + "\n");
}

/// Keeps a picture as SLAMICP_OUT/name.svg and .png, where that is set.
inline void save_picture(const std::string& name, const Picture& picture) {
  for (const char* ending : {".svg", ".png"})
    if (const auto path = out(name + ending); !path.empty()) picture.save(path);
}

/// The smallest value that `share` of the values do not exceed; 0 of none.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(values.size())) - 1.0;
  return values[static_cast<std::size_t>(std::clamp(rank, 0.0, static_cast<double>(values.size() - 1)))];
}

inline double mean(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

class Stopwatch {
 public:
  double microseconds() const {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start_).count();
  }
  double milliseconds() const { return 1e-3 * microseconds(); }
  double seconds() const { return 1e-6 * microseconds(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A Markdown table on stdout.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}

  void add(std::vector<std::string> row) {
    row.resize(rows_.front().size(), "-");
    rows_.push_back(std::move(row));
  }

  void print() const {
    std::vector<std::size_t> width(rows_.front().size(), 3);
    for (const auto& row : rows_)
      for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
    std::vector<std::string> rule;
    rule.reserve(width.size());
    for (const std::size_t w : width) rule.emplace_back(w, '-');
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      print_row(rows_[k], width);
      if (k == 0) print_row(rule, width);
    }
    std::printf("\n");
  }

 private:
  static void print_row(const std::vector<std::string>& row, const std::vector<std::size_t>& width) {
    for (std::size_t k = 0; k < row.size(); ++k) std::printf("| %-*s ", static_cast<int>(width[k]), row[k].c_str());
    std::printf("|\n");
  }

  std::vector<std::vector<std::string>> rows_;
};

/// The words after the program's name, pairs `--name value`.
class Words {
 public:
  Words(int argc, char** argv, std::map<std::string, std::string> defaults) : values_(std::move(defaults)) {
    for (int k = 1; k < argc; k += 2) {
      const auto found = values_.find(argv[k]);
      if (found == values_.end() || k + 1 == argc) {
        std::string known;
        for (const auto& [name, value] : values_) known += " " + name + " " + (value.empty() ? "..." : value);
        throw std::invalid_argument("cannot use '" + std::string(argv[k]) + "'; options and defaults:" + known);
      }
      found->second = argv[k + 1];
    }
  }

  const std::string& operator[](const std::string& name) const { return values_.at(name); }
  double number(const std::string& name) const { return std::stod(values_.at(name)); }

 private:
  std::map<std::string, std::string> values_;
};

/// The whole of a measurement's main(): runs it, tells what is wrong on stderr, returns the exit status.
inline int run(const std::function<void()>& measurement) {
  try {
    measurement();
    return 0;
  } catch (const std::invalid_argument& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 2;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}

}  // namespace slamicp::measure
