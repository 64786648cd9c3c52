// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdio>

#include <slamicp/localization/quality.hpp>

namespace slamicp {

const char* to_string(TrackingState state) noexcept {
  switch (state) {
    case TrackingState::tracking:
      return "tracking";
    case TrackingState::degenerate:
      return "degenerate";
    case TrackingState::suspect:
      return "suspect";
    case TrackingState::lost:
      return "lost";
  }
  return "?";
}

std::string Quality::brief() const {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%s, %.1f %% sure, %.0f %% of the surroundings explained", to_string(state),
                100.0 * probability, 100.0 * awareness);
  return text.data();
}

std::string QualityOptions::problem() const {
  if (rays != 0 && (rays < 16 || rays > 256)) return "rays must be 0 or 16 to 256";
  if (!(suspect_below > 0.0 && suspect_below < 1.0)) return "suspect_below must be in (0, 1)";
  if (!(trusted_above > suspect_below && trusted_above < 1.0)) return "trusted_above must be in (suspect_below, 1)";
  if (lost_after < 1) return "lost_after must be at least 1 scan";
  if (!(memory >= 1.0)) return "memory must be at least 1 scan";
  if (!(awareness_memory >= 1.0)) return "awareness_memory must be at least 1 scan";
  return {};
}

}  // namespace slamicp
