// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/io/carmen_log.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr std::string_view heading =
    "# CARMEN Logfile\n"
    "# written by slamicp; one message per line\n"
    "# ROBOTLASER1 type start_angle fov angular_resolution max_range accuracy remission_mode n r_0..r_(n-1) m "
    "rem_0..rem_(m-1) lx ly lth ox oy oth tv rv forward_safety side_safety turn_axis ipc_timestamp ipc_hostname "
    "logger_timestamp\n";

void append_number(std::string& out, double number) {
  out += ' ';
  text::append_exact(out, number);
}

void append_pose(std::string& out, const Pose2& pose) {
  append_number(out, pose.x);
  append_number(out, pose.y);
  append_number(out, pose.theta);
}

/// The format has no smallest range and no NaN: what is no return and not far is written as 0.
void append_range(std::string& out, const LaserScan& scan, float range) {
  out += ' ';
  if (is_return(scan, range))
    text::append_exact(out, range);
  else if (static_cast<double>(range) >= scan.range_max)
    text::append_exact(out, scan.range_max);
  else
    out += '0';
}

void append_message(std::string& out, const LaserScan& scan) {
  out += "ROBOTLASER1 0";
  append_number(out, scan.angle_min);
  append_number(out, field_of_view(scan));
  append_number(out, scan.angle_increment);
  append_number(out, scan.range_max);
  out += " 0.01 0 " + std::to_string(scan.ranges.size());
  for (const float range : scan.ranges) append_range(out, scan, range);
  out += " 0";
  const Pose2 T_odom_robot = scan.T_odom_robot.value_or(Pose2{});
  append_pose(out, T_odom_robot * scan.T_robot_laser);
  append_pose(out, T_odom_robot);
  out += " 0 0 0 0 0 ";
  text::append_fixed(out, scan.stamp, 6);
  out += " slamicp ";
  text::append_fixed(out, scan.stamp, 6);
  out += '\n';
}

std::string problem_of(const LaserScan& scan) {
  if (scan.ranges.empty()) return "has no beams";
  if (!std::isfinite(scan.stamp)) return "has a stamp that is not a number";
  if (!std::isfinite(scan.angle_min)) return "has an angle_min that is not a number";
  if (!std::isfinite(scan.angle_increment) || scan.angle_increment == 0.0)
    return "has an angle_increment of 0 or that is not a number";
  if (!(scan.range_max > 0.0)) return "has a range_max that is not above 0";
  if (!scan.T_robot_laser.is_finite()) return "has a T_robot_laser that is not finite";
  if (scan.T_odom_robot && !scan.T_odom_robot->is_finite()) return "has a T_odom_robot that is not finite";
  return {};
}

}  // namespace

std::string carmen_log_text(std::span<const LaserScan> scans) {
  std::string out(heading);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (const std::string problem = problem_of(scans[i]); !problem.empty())
      throw Error("scan " + std::to_string(i) + ' ' + problem, "CARMEN log", "mend the scan before saving it");
    append_message(out, scans[i]);
  }
  return out;
}

}  // namespace slamicp
