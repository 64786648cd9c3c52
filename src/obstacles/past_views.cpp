// SPDX-License-Identifier: Apache-2.0
#include "obstacles/past_views.hpp"

namespace slamicp {
namespace {

constexpr double seconds_between_views = 0.12;

}  // namespace

int PastViews::keep(const LaserView& view, double stamp) {
  const Kept& newest = kept_[static_cast<std::size_t>(last_)];
  if (newest.serial > 0 && stamp - newest.stamp < seconds_between_views) return -1;
  // Memory for all of them at once: later ones are to take none.
  if (newest.ranges.capacity() < view.ranges().size()) {
    clear();
    for (Kept& kept : kept_) kept.ranges.reserve(view.ranges().size());
  }
  last_ = (last_ + 1) % most;
  Kept& kept = kept_[static_cast<std::size_t>(last_)];
  kept.ranges.assign(view.ranges().begin(), view.ranges().end());
  kept.view = view.with(kept.ranges);
  kept.stamp = stamp;
  kept.serial = ++serial_;
  return last_;
}

void PastViews::clear() noexcept {
  for (Kept& kept : kept_) kept.serial = 0;
}

FreeSpace free_space(const LaserView& view, const Footprint& footprint, const ViewErrors& errors,
                     bool sees_beyond) noexcept {
  FreeSpace space;
  for (int k = 0; k < footprint.count; ++k) {
    const Point2& place = footprint.points[static_cast<std::size_t>(k)];
    const Sight sight = view.look(place, errors.margin, errors.shift, errors.turn);
    space.free += sight == Sight::free || (sight == Sight::silent && !sees_beyond) ? 1 : 0;
    space.taken += sight == Sight::taken ? 1 : 0;
  }
  return space;
}

}  // namespace slamicp
