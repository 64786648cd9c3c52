// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// Whether somebody can stand and walk somewhere: what stands in a world, doors as they are now, people left out.
class Clearance {
 public:
  explicit Clearance(const World& world);

  /// True where the whole way from a to b stays at least `margin` [m], > 0, from everything. O(things).
  bool is_clear(const Point2& a, const Point2& b, double margin) const noexcept;
  bool is_clear(const Point2& point, double margin) const noexcept { return is_clear(point, point, margin); }

 private:
  std::vector<Segment> edges_;
  std::vector<Circle> rounds_;
};

}  // namespace slamicp
