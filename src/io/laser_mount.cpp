// SPDX-License-Identifier: Apache-2.0
#include "io/laser_mount.hpp"

#include <slamicp/geometry/angle.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr double most_tilt_deg = 1.0;  // at 10 m a beam is 17 cm off its plane

std::string between(const std::string& laser, const std::string& base) { return "'" + laser + "' to '" + base + "'"; }

}  // namespace

LaserMount laser_mount(const FrameTree& frames, const std::string& base, const std::string& laser,
                       std::vector<std::string>& warnings) {
  if (laser == base) return {};
  const std::optional<FrameTree::Mount> found = frames.mount(base, laser);
  if (!found) {
    warnings.push_back("no transform from " + between(laser, base) +
                       ": the laser is taken to sit at the robot's centre; give --laser-offset");
    return {};
  }
  if (found->moves)
    warnings.push_back("the transform from " + between(laser, base) + " changes: the first is used throughout");
  const LaserMount mount = laser_mount(found->T_base_frame);
  const double tilt_deg = mount.tilt * deg_per_rad;
  if (tilt_deg > most_tilt_deg) {
    std::string warning = "laser '" + laser + "' is tilted by ";
    text::append_fixed(warning, tilt_deg, 1);
    warnings.push_back(warning + " deg: it is taken as level");
  }
  return mount;
}

}  // namespace slamicp
