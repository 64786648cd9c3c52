// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <iostream>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <slamicp/io/output_file.hpp>

namespace slamicp::command {
namespace {

bool stderr_is_terminal() {
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(fileno(stderr)) != 0;
#endif
}

}  // namespace

void add_json(CLI::App& verb, std::string& file) {
  verb.add_option("--json", file, "write a machine-readable summary; '-' is stdout")->type_name("FILE");
}

void write_json(const std::string& file, const Json& summary) {
  if (!file.empty()) write_file(file_named(file), summary.dump(2) + "\n");
}

Json to_json(const Pose2& pose) { return {{"x", pose.x}, {"y", pose.y}, {"theta", pose.theta}}; }

Json to_json(const ErrorStatistics& errors) {
  return {{"count", errors.count}, {"mean", errors.mean}, {"std", errors.standard_deviation},
          {"rmse", errors.rmse},   {"p95", errors.p95},   {"max", errors.max}};
}

void Talk::operator()(const std::string& line) const { (to_stderr_ ? std::cerr : std::cout) << line << '\n'; }

void warn(const std::string& message) { std::cerr << "slamicp: warning: " << message << '\n'; }
void warn(const std::vector<std::string>& messages) {
  for (const std::string& message : messages) warn(message);
}

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(std::max<std::size_t>(total, 1)), visible_(stderr_is_terminal()) {}

Progress::~Progress() {
  if (visible_) std::fprintf(stderr, "\r%*s\r", 60, "");
}

void Progress::step() {
  ++done_;
  const int percent = static_cast<int>(100 * done_ / total_);
  if (!visible_ || percent == shown_) return;
  shown_ = percent;
  const std::string bar(static_cast<std::size_t>(percent * 30 / 100), '#');
  std::fprintf(stderr, "\r%s [%-30s] %3d %%", what_.c_str(), bar.c_str(), percent);
  std::fflush(stderr);
}

std::filesystem::path file_named(const std::string& name) { return std::u8string(name.begin(), name.end()); }

std::vector<const char*> picture_endings() {
#ifdef SLAMICP_WITH_PNG
  return {".svg", ".png"};
#else
  return {".svg"};
#endif
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      safe += c;
  }
  return safe;
}

std::string format(const char* pattern, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

}  // namespace slamicp::command
