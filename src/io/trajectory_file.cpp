// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/io/output_file.hpp>
#include <slamicp/io/trajectory_file.hpp>

#include "io/number_table.hpp"

namespace slamicp {

Trajectory parse_trajectory(std::string_view text, const std::string& name) {
  const std::string form = "stamp x y z qx qy qz qw";
  Trajectory trajectory;
  read_number_table<8>(text, name, form, [&](const std::array<double, 8>& line, const text::Lines& lines) {
    const auto& [stamp, x, y, z, qx, qy, qz, qw] = line;
    const double length = std::sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
    // Files carry few decimals; what is far from 1 is no quaternion, but other columns.
    if (!(std::abs(length - 1.0) < 0.01))
      throw Error("the quaternion is not of length 1", lines.where(), "write " + form);
    const double heading = std::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz));
    trajectory.push_back({stamp, {x, y, wrap_angle(heading)}});
  });
  return trajectory;
}

Trajectory load_trajectory(const std::filesystem::path& path) {
  return parse_trajectory(text::read_file(path), text::name_of(path));
}

std::string trajectory_text(std::span<const StampedPose> trajectory) {
  std::string out;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const auto& [stamp, pose] = trajectory[i];
    if (!pose.is_finite() || !std::isfinite(stamp))
      throw Error("pose " + std::to_string(i) + " is not finite", "trajectory", "leave it out");
    text::append_fixed(out, stamp, 6);
    out += ' ';
    text::append_fixed(out, pose.x, 6);
    out += ' ';
    text::append_fixed(out, pose.y, 6);
    out += " 0 0 0 ";
    text::append_fixed(out, std::sin(0.5 * pose.theta), 9);
    out += ' ';
    text::append_fixed(out, std::cos(0.5 * pose.theta), 9);
    out += '\n';
  }
  return out;
}

void save_trajectory(const std::filesystem::path& path, std::span<const StampedPose> trajectory) {
  write_file(path, trajectory_text(trajectory));
}

}  // namespace slamicp
