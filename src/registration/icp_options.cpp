// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/registration/icp_options.hpp>

namespace slamicp {
namespace {

bool is_length(double value) noexcept { return std::isfinite(value) && value > 0.0; }

}  // namespace

std::string IcpOptions::problem() const {
  if (!is_length(max_correspondence_distance))
    return "max_correspondence_distance must be a length above 0 m; 0.3 m is the paper's";
  if (outlier_distance && !is_length(*outlier_distance))
    return "outlier_distance must be a length above 0 m; leave it out to use max_correspondence_distance";
  if (obstacle_distance && !is_length(*obstacle_distance))
    return "obstacle_distance must be a length above 0 m; leave it out to have it from the noise";
  if (max_iterations < 1) return "max_iterations must be at least 1; 50 is the default";
  if (!is_length(kernel_scale)) return "kernel_scale must be a length above 0 m; 0.05 m is the default";
  if (!(final_gate >= 0.0) || final_gate > max_correspondence_distance)
    return "final_gate must lie between 0 (from the map) and max_correspondence_distance";
  if (!(guess_share >= 0.0 && guess_share <= 1.0)) return "guess_share must lie between 0 (not at all) and 1";
  if (!is_length(translation_tolerance)) return "translation_tolerance must be above 0 m; 1e-4 is the default";
  if (!is_length(rotation_tolerance)) return "rotation_tolerance must be above 0 rad; 1e-4 is the default";
  if (const std::string in_noise = noise.problem(); !in_noise.empty()) return in_noise;
  if (!is_available(instruction_set))
    return std::string("instruction_set ") + to_string(instruction_set) +
           " is not available on this machine or in this build; leave it at best";
  return {};
}

}  // namespace slamicp
