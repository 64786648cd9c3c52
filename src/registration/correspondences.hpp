// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <slamicp/search/indexed_points.hpp>

namespace slamicp {

/// The nearest map point of every scan point, kept from one pose to the next.
///
/// A search leaves behind where it was made and how far every other map point was at least (d2). When the point
/// has since moved by m, every other one is at least d2 - m away; if its old neighbour is nearer than that, it is still
/// the nearest, and no search is needed: exactly, not approximately (the triangle inequality).
template <int D>
class Correspondences {
 public:
  /// @param reach  distances at or beyond are all the same to the caller [m]
  void reset(const IndexedPoints<D>& map, PointView<D> scan, double reach) {
    map_ = &map;
    reach_ = reach;
    searches_ = 0;
    held_.assign(scan.size(), Held{});
    usable_ = 0;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      held_[i].finite = is_finite<D>(scan[i]);
      usable_ += held_[i].finite ? 1U : 0U;
    }
  }

  void reserve(std::size_t points) { held_.reserve(points); }

  /// Scan points that are numbers.
  std::size_t usable_points() const noexcept { return usable_; }
  std::size_t searches() const noexcept { return searches_; }
  bool finite(std::size_t i) const noexcept { return held_[i].finite; }

  /// The exact nearest map point of scan point i, which is now at `position`.
  Neighbour nearest(std::size_t i, const Point<D>& position) noexcept {
    Held& held = held_[i];
    const double others = others_now(held, position);
    const double kept = squared_distance_to(held, position);
    const bool same = others > 0.0 && kept < others * others;
    const bool still_none = others >= reach_ && kept >= reach_ * reach_;
    if (same || still_none) return answer(held.index, kept);
    search(held, position);
    return answer(held.index, squared_distance_to(held, position));
  }

  /// True if scan point i at `position` is closer than `threshold` to some map point. Never searches where that is
  /// certain without: less often than nearest() does.
  bool closer_than(std::size_t i, const Point<D>& position, double threshold) noexcept {
    Held& held = held_[i];
    const double threshold2 = threshold * threshold;
    if (squared_distance_to(held, position) < threshold2) return true;
    if (others_now(held, position) >= threshold) return false;
    search(held, position);
    return squared_distance_to(held, position) < threshold2;
  }

 private:
  struct Held {
    Point<D> searched_at = Point<D>::Zero();
    double others = 0.0;  // at searched_at, no other map point was closer [m]; 0: never searched
    int index = -1;
    bool finite = false;
  };

  // How much farther than needed a search looks, so that a point with nothing near it can move without a new one.
  static constexpr double slack = 1.1;

  double squared_distance_to(const Held& held, const Point<D>& position) const noexcept {
    if (held.index < 0) return std::numeric_limits<double>::infinity();
    return (map_->points()[static_cast<std::size_t>(held.index)] - position).squaredNorm();
  }

  // A lower bound on the distance to every map point but the held one.
  double others_now(const Held& held, const Point<D>& position) const noexcept {
    constexpr double rounding = 1e-9;  // [m]; coordinates up to 1,000 km keep it in double
    return held.others - (position - held.searched_at).norm() - rounding;
  }

  Neighbour answer(int index, double squared_distance) const noexcept {
    if (!(squared_distance < reach_ * reach_)) return {};
    return {index, squared_distance};
  }

  void search(Held& held, const Point<D>& position) noexcept {
    const NearestTwo found = map_->nearest_two(position, slack * reach_);
    held.index = found.nearest.index;
    held.others = std::sqrt(found.others_squared_distance);
    held.searched_at = position;
    ++searches_;
  }

  const IndexedPoints<D>* map_ = nullptr;
  double reach_ = 0.0;
  std::size_t searches_ = 0;
  std::size_t usable_ = 0;
  std::vector<Held> held_;
};

}  // namespace slamicp
