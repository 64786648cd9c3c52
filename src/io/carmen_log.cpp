// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/io/carmen_log.hpp>

#include "io/carmen_messages.hpp"
#include "io/laser_offset.hpp"
#include "io/log_checks.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr std::string_view flaser = "FLASER";
constexpr std::string_view robotlaser = "ROBOTLASER1";

/// Counts by kind. Names that no CARMEN program writes go together: a broken file may hold any number of them.
void count_message(ScanLog& log, std::string_view kind) {
  const bool plausible = kind.size() <= 32 && std::all_of(kind.begin(), kind.end(), [](char c) {
                           return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
                         });
  const std::string_view name = plausible ? kind : "other";
  const auto found = log.messages.find(name);
  if (found == log.messages.end())
    log.messages.emplace(name, 1);
  else
    ++found->second;
}

/// Both kinds in one log are the same scans twice, as new CARMEN loggers write them.
void keep_one_kind(ScanLog& log, std::vector<CarmenScan>& scans) {
  if (!log.messages.contains(flaser) || !log.messages.contains(robotlaser)) return;
  std::erase_if(scans, [](const CarmenScan& scan) { return scan.is_flaser; });
  log.warnings.push_back("holds FLASER and ROBOTLASER1 messages, the same laser twice: ROBOTLASER1 is used");
}

std::vector<CarmenScan> read_messages(std::string_view text, const std::string& name, ScanLog& log) {
  std::vector<CarmenScan> scans;
  text::Lines lines(text, name);
  while (lines.next()) {
    text::Tokens tokens(lines.line());
    std::string_view kind;
    if (!tokens.next(kind) || kind.starts_with('#')) continue;
    try {
      if (kind == flaser)
        scans.push_back(parse_flaser(tokens, lines));
      else if (kind == robotlaser)
        scans.push_back(parse_robotlaser(tokens, lines));
    } catch (const Error& error) {
      if (!lines.cut()) throw;
      log.warnings.push_back("line " + std::to_string(lines.number()) + ", the last, is cut: left out (" +
                             error.problem() + ")");
      break;
    }
    count_message(log, kind.empty() ? "other" : kind);
  }
  return scans;
}

void drop_unknown_odometry(ScanLog& log) {
  const bool all_zero = std::all_of(log.begin(), log.end(), [](const LaserScan& scan) {
    return scan.T_odom_robot->x == 0.0 && scan.T_odom_robot->y == 0.0 && scan.T_odom_robot->theta == 0.0;
  });
  if (!all_zero) return;
  for (LaserScan& scan : log.scans) scan.T_odom_robot.reset();
  log.warnings.push_back("odometry is 0 0 0 in every scan: taken as not known");
}

[[noreturn]] void fail_without_scans(const ScanLog& log) {
  std::string found;
  for (const auto& [kind, count] : log.messages) found += ' ' + std::to_string(count) + ' ' + kind;
  throw Error("holds no scan" + (found.empty() ? std::string() : "; messages found:" + found), log.name,
              "give a log with FLASER or ROBOTLASER1 messages");
}

}  // namespace

ScanLog parse_carmen_log(std::string_view text, const std::string& name, const ScanLogOptions& options) {
  require_valid(options);
  ScanLog log;
  log.name = name;
  log.format = "CARMEN";
  std::vector<CarmenScan> scans = read_messages(text, name, log);
  if (scans.empty()) fail_without_scans(log);
  keep_one_kind(log, scans);
  const Pose2 T_robot_laser = options.laser_offset ? *options.laser_offset : laser_offset(scans, log.warnings);
  log.scans.reserve(scans.size());
  for (CarmenScan& scan : scans) {
    scan.scan.T_robot_laser = T_robot_laser;
    log.scans.push_back(std::move(scan.scan));
  }
  drop_unknown_odometry(log);
  warn_of_backward_stamps(log);
  if (!log.messages.contains(robotlaser)) drop_no_return_constant(log);
  return log;
}

}  // namespace slamicp
