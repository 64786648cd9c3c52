// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdio>

#include <slamicp/obstacles/shape.hpp>

namespace slamicp {

const char* to_string(ShapeKind kind) noexcept {
  switch (kind) {
    case ShapeKind::unknown:
      return "unknown";
    case ShapeKind::line:
      return "line";
    case ShapeKind::circle:
      return "circle";
    case ShapeKind::box:
      return "box";
  }
  return "?";
}

std::string Shape::brief() const {
  std::array<char, 160> text{};
  const auto or_more = [](bool seen) { return seen ? "" : " or more"; };
  switch (kind) {
    case ShapeKind::circle:
      std::snprintf(text.data(), text.size(), "circle, radius %.3f m (+- %.3f m)", radius, radius_sigma);
      break;
    case ShapeKind::line:
      std::snprintf(text.data(), text.size(), "line, %.3f m%s", width, or_more(width_seen));
      break;
    case ShapeKind::box:
      std::snprintf(text.data(), text.size(), "box, %.3f m%s x %.3f m%s", width, or_more(width_seen), depth,
                    or_more(depth_seen));
      break;
    case ShapeKind::unknown:
      std::snprintf(text.data(), text.size(), "unknown, about %.2f m x %.2f m", width, depth);
      break;
  }
  return text.data();
}

}  // namespace slamicp
