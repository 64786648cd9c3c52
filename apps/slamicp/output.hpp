// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <slamicp/evaluation/error_statistics.hpp>
#include <slamicp/geometry/pose.hpp>

// MinGW's printf is the standard's (%zu), where libstdc++ is; its attribute is to know.
#ifdef __MINGW_PRINTF_FORMAT
#define SLAMICP_PRINTF __MINGW_PRINTF_FORMAT
#else
#define SLAMICP_PRINTF printf
#endif

namespace slamicp::command {

using Json = nlohmann::ordered_json;

/// `--json FILE`: the machine-readable summary of any verb; "-" is stdout.
void add_json(CLI::App& verb, std::string& file);
/// Writes it where it was asked for.
void write_json(const std::string& file, const Json& summary);

Json to_json(const Pose2& pose);
Json to_json(const ErrorStatistics& errors);

/// A line for people: on stdout, unless the summary goes there.
class Talk {
 public:
  explicit Talk(const std::string& json_file) : to_stderr_(json_file == "-") {}
  void operator()(const std::string& line) const;

 private:
  bool to_stderr_;
};

/// A problem that does not stop us, on stderr.
void warn(const std::string& message);
void warn(const std::vector<std::string>& messages);

/// A progress bar on stderr, only on a terminal.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  void step();

 private:
  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  int shown_ = -1;
  bool visible_;
};

/// Microseconds since it was made.
class Stopwatch {
 public:
  double microseconds() const {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The file that UTF-8 words name. Windows' own way from std::string to a path knows other letters.
std::filesystem::path file_named(const std::string& name);

/// What pictures are saved as, each as all of these: ".svg", and ".png" where this build has it.
std::vector<const char*> picture_endings();

/// The middle value; 0 of none.
double median(std::vector<double> values);

/// A text as HTML shows it.
std::string escaped(const std::string& text);

/// printf into a string.
[[gnu::format(SLAMICP_PRINTF, 1, 2)]] std::string format(const char* pattern, ...);

}  // namespace slamicp::command
