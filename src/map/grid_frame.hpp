// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/map/occupancy_grid.hpp>

namespace slamicp {

/// Cells without end in every direction, counted from the origin that the options name.
class GridFrame {
 public:
  explicit GridFrame(const GridOptions& options) : options_(options), T_grid_map_(options.origin.inverse()) {
    if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "GridOptions");
  }

  const GridOptions& options() const noexcept { return options_; }

  /// In cells, from the origin.
  Point2 in_cells(const Point2& point_in_map) const noexcept {
    return (T_grid_map_ * point_in_map) / options_.resolution;
  }

  /// The cells, padding included, around what lies within `bounds` [cells].
  Point2 first_cell(const Bounds<2>& bounds) const noexcept { return bounds.lower.array().floor() - padding(); }
  Point2 last_cell(const Bounds<2>& bounds) const noexcept { return bounds.upper.array().floor() + padding(); }

  /// Throws Error where cells from `first` to `last`, both included, are too many.
  void check_size(const Point2& first, const Point2& last) const;

  /// Unknown cells from `first` to `last`, both included. Throws Error where they would be too many.
  OccupancyGrid unknown_grid(const Point2& first, const Point2& last) const;

 private:
  double padding() const noexcept { return std::ceil(options_.padding / options_.resolution); }

  GridOptions options_;
  Pose2 T_grid_map_;
};

}  // namespace slamicp
