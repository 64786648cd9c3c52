// SPDX-License-Identifier: Apache-2.0
#include "io/carmen_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <slamicp/error.hpp>

namespace slamicp {
namespace {

/// Takes a message apart, number by number, and says what is missing where one is.
class Fields {
 public:
  Fields(text::Tokens& tokens, const text::Lines& lines, const char* form)
      : tokens_(tokens), lines_(lines), form_(form) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(what, lines_.where(), std::string("write ") + form_ + ", or take the line out");
  }

  std::string_view word(const char* name) {
    std::string_view token;
    if (!tokens_.next(token)) fail(std::string("the line ends before its ") + name);
    return token;
  }

  double number(const char* name) {
    const std::string_view token = word(name);
    const std::optional<double> number = text::to_number<double>(token);
    if (!number || !std::isfinite(*number)) fail(std::string(name) + " is not a number: " + text::quoted(token));
    return *number;
  }

  std::size_t count(const char* name) {
    const std::string_view token = word(name);
    const std::optional<std::uint32_t> count = text::to_number<std::uint32_t>(token);
    if (!count) fail(std::string(name) + " is not a whole number: " + text::quoted(token));
    if (*count > lines_.line().size())
      fail(std::string(name) + " is " + std::to_string(*count) + ": more than the line holds");
    return *count;
  }

  std::vector<float> ranges(std::size_t count) {
    std::vector<float> ranges;
    ranges.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view token;
      if (!tokens_.next(token)) fail("the line ends at range " + std::to_string(i) + " of " + std::to_string(count));
      const std::optional<float> range = text::to_number<float>(token);
      if (!range) fail("range " + std::to_string(i) + " is not a number: " + text::quoted(token));
      ranges.push_back(*range);
    }
    return ranges;
  }

  Pose2 pose(const char* name) {
    const double x = number(name);
    const double y = number(name);
    return {x, y, wrap_angle(number(name))};
  }

 private:
  text::Tokens& tokens_;
  const text::Lines& lines_;
  const char* form_;
};

/// What an FLASER of so many beams means. With 181 and 361 the last beam points to +90 deg, with 180 and 360 one step
/// short of it: these stand for a Sick LMS in its two resolutions.
double flaser_increment(std::size_t beams) {
  constexpr double pi = std::numbers::pi;
  if (beams == 180) return pi / 180.0;
  if (beams == 360) return pi / 360.0;
  return beams > 1 ? pi / static_cast<double>(beams - 1) : 0.0;
}

void read_poses(Fields& fields, CarmenScan& scan) {
  scan.T_odom_laser = fields.pose("laser pose");
  scan.scan.T_odom_robot = fields.pose("robot pose");
}

/// The host name after the stamp must be there: without it the stamp itself may be cut.
void read_stamp(Fields& fields, CarmenScan& scan) {
  scan.scan.stamp = fields.number("ipc_timestamp");
  fields.word("ipc_hostname");
}

}  // namespace

CarmenScan parse_flaser(text::Tokens& tokens, const text::Lines& lines) {
  Fields fields(tokens, lines, "FLASER n r_0..r_(n-1) lx ly lth ox oy oth ipc_timestamp ipc_hostname logger_timestamp");
  CarmenScan scan;
  scan.is_flaser = true;
  const std::size_t beams = fields.count("number of readings");
  if (beams == 0) fields.fail("a scan without readings");
  scan.scan.ranges = fields.ranges(beams);
  scan.scan.angle_min = -0.5 * std::numbers::pi;
  scan.scan.angle_increment = flaser_increment(beams);
  read_poses(fields, scan);
  read_stamp(fields, scan);
  return scan;
}

CarmenScan parse_robotlaser(text::Tokens& tokens, const text::Lines& lines) {
  Fields fields(
      tokens, lines,
      "ROBOTLASER1 type start_angle fov angular_resolution max_range accuracy remission_mode n r_0..r_(n-1) m "
      "rem_0..rem_(m-1) lx ly lth ox oy oth tv rv forward_safety side_safety turn_axis ipc_timestamp "
      "ipc_hostname logger_timestamp");
  CarmenScan scan;
  fields.word("laser type");
  scan.scan.angle_min = fields.number("start_angle");
  const double fov = fields.number("field of view");
  const double resolution = fields.number("angular_resolution");
  const double range_max = fields.number("max_range");
  fields.number("accuracy");
  fields.word("remission_mode");
  const std::size_t beams = fields.count("number of readings");
  if (beams == 0) fields.fail("a scan without readings");
  if (resolution == 0.0 && fov == 0.0) fields.fail("angular_resolution and field of view are both 0");
  scan.scan.ranges = fields.ranges(beams);
  scan.scan.angle_increment =
      resolution != 0.0 ? resolution : fov / static_cast<double>(std::max<std::size_t>(beams - 1, 1));
  // A reading of 29.9 is slightly less than 29.9 once it is a float; it means no return all the same.
  if (range_max > 0.0) scan.scan.range_max = std::min(range_max, static_cast<double>(static_cast<float>(range_max)));
  fields.ranges(fields.count("number of remissions"));
  read_poses(fields, scan);
  for (const char* name : {"tv", "rv", "forward_safety", "side_safety", "turn_axis"}) fields.number(name);
  read_stamp(fields, scan);
  return scan;
}

}  // namespace slamicp
