// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <slamicp/map/grid_builder.hpp>

#include "map/grid_frame.hpp"

namespace slamicp {
namespace {

/// Walks from cell to cell along a ray (Amanatides and Woo 1987, "A Fast Voxel Traversal Algorithm for Ray Tracing"),
/// to the cell before the last. Both ends in cells, none of them below 0.
/// @param strides  from a cell to the next column, and to the next row
template <class Pass>
void walk(const Point2& from, const Point2& to, const std::array<std::ptrdiff_t, 2>& strides, Pass pass) {
  std::array<std::ptrdiff_t, 2> left{}, step{};          // cells to go along each axis; in the order of the cells
  std::array<double, 2> to_border{}, between_borders{};  // as shares of the way
  std::ptrdiff_t index = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<int>(axis);
    const double way = to[k] - from[k];
    const double cell = std::floor(from[k]);
    left[axis] = static_cast<std::ptrdiff_t>(std::abs(std::floor(to[k]) - cell));
    step[axis] = way > 0.0 ? strides[axis] : -strides[axis];
    between_borders[axis] = 1.0 / std::abs(way);
    to_border[axis] = left[axis] > 0 ? ((way > 0.0 ? cell + 1.0 : cell) - from[k]) / way : 2.0;
    index += static_cast<std::ptrdiff_t>(cell) * strides[axis];
  }
  while (left[0] + left[1] > 0) {
    pass(index);
    const std::size_t axis = to_border[0] < to_border[1] ? 0 : 1;
    index += step[axis];
    to_border[axis] = --left[axis] == 0 ? 2.0 : to_border[axis] + between_borders[axis];
  }
}

}  // namespace

/// Counts for the cells of a rectangle that grows.
class GridBuilder::Tallies {
 public:
  struct Tally {
    std::uint32_t ended = 0;     ///< rays
    std::uint32_t passed = 0;    ///< rays
    std::uint32_t ended_in = 0;  ///< the last scan that had a ray end here, counted from 1
  };

  explicit Tallies(const GridOptions& options) : frame_(options) {}

  const GridFrame& frame() const noexcept { return frame_; }
  const Bounds<2>& seen() const noexcept { return seen_; }

  /// Makes room for all within the bounds [cells].
  void make_room(const Bounds<2>& bounds) {
    Bounds<2> seen = seen_;
    seen.include(bounds.lower);
    seen.include(bounds.upper);
    const Point2 first = seen.lower.array().floor();
    const Point2 last = seen.upper.array().floor();
    frame_.check_size(first, last);
    seen_ = seen;
    if (!tallies_.empty() && (first.array() >= first_.array()).all() &&
        (last.array() < first_.array() + size_.array()).all())
      return;
    // Half as much again, so that a growing map is not moved with each scan.
    const Point2 slack = (0.25 * (last - first)).array().ceil() + 16.0;
    move_to(first - slack, last - first + 2.0 * slack + Point2::Ones());
  }

  /// Counts rays, all within the room that was made [cells].
  void count(const Point2& laser, const PointCloud2& ends) {
    ++scan_;
    const auto width = static_cast<std::ptrdiff_t>(size_.x());
    for (const Point2& end : ends) {
      const Point2 cell = end.array().floor() - first_.array();
      Tally& tally = tallies_[static_cast<std::size_t>(cell.y() * size_.x() + cell.x())];
      ++tally.ended;
      tally.ended_in = scan_;
    }
    for (const Point2& end : ends)
      walk(laser - first_, end - first_, {1, width}, [this](std::ptrdiff_t index) {
        Tally& tally = tallies_[static_cast<std::size_t>(index)];
        tally.passed += tally.ended_in != scan_;
      });
  }

  /// Whether less than a share of the rays that ended here or in one of the four cells beside it ended here.
  bool is_outshone(const Point2& cell, double share) const noexcept {
    std::uint32_t most = 0;
    for (const Point2& side : {Point2(1, 0), Point2(-1, 0), Point2(0, 1), Point2(0, -1)})
      most = std::max(most, tally(cell + side).ended);
    const double here = tally(cell).ended;
    return here < share * (here + most);
  }

  /// None outside.
  Tally tally(const Point2& cell) const noexcept {
    const Point2 from_first = cell - first_;
    if ((from_first.array() < 0.0).any() || (from_first.array() >= size_.array()).any()) return {};
    return tallies_[static_cast<std::size_t>(from_first.y() * size_.x() + from_first.x())];
  }

 private:
  void move_to(const Point2& first, const Point2& size) {
    std::vector<Tally> larger(static_cast<std::size_t>(size.x() * size.y()));
    const Point2 shift = first_ - first;
    const auto width = static_cast<std::size_t>(size_.x());
    for (std::size_t row = 0; row * width < tallies_.size(); ++row) {
      const auto from = tallies_.begin() + static_cast<std::ptrdiff_t>(row * width);
      const double to = (static_cast<double>(row) + shift.y()) * size.x() + shift.x();
      std::copy_n(from, width, larger.begin() + static_cast<std::ptrdiff_t>(to));
    }
    tallies_ = std::move(larger);
    first_ = first;
    size_ = size;
  }

  GridFrame frame_;
  Bounds<2> seen_;                 ///< by rays, without slack [cells]
  Point2 first_ = Point2::Zero();  ///< the cell of the first tally
  Point2 size_ = Point2::Zero();   ///< [cells]
  std::vector<Tally> tallies_;     ///< row by row
  std::uint32_t scan_ = 0;         ///< counted so far
};

std::string GridBuilderOptions::problem() const {
  if (std::string rule = grid.problem(); !rule.empty()) return rule;
  if (!(occupied_share > 0.0 && occupied_share <= 0.5)) return "occupied_share must be above 0 and at most 0.5";
  return {};
}

GridBuilder::GridBuilder(const GridBuilderOptions& options) : options_(options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "GridBuilderOptions");
  tallies_ = std::make_unique<Tallies>(options.grid);
}
GridBuilder::~GridBuilder() = default;
GridBuilder::GridBuilder(GridBuilder&&) noexcept = default;
GridBuilder& GridBuilder::operator=(GridBuilder&&) noexcept = default;

void GridBuilder::add(const LaserScan& scan, const Pose2& T_map_robot) {
  to_points(scan, options_.ranges, points_);
  add(points_.in_robot, scan.T_robot_laser.translation(), T_map_robot);
}

void GridBuilder::add(PointView<2> points_in_robot, const Point2& laser_in_robot, const Pose2& T_map_robot) {
  if (!T_map_robot.is_finite())
    throw Error("the pose of a scan is not finite", "GridBuilder::add", "leave out scans whose pose is not known");
  if (points_in_robot.empty()) return;
  const GridFrame& frame = tallies_->frame();
  const Point2 laser = frame.in_cells(T_map_robot * laser_in_robot);
  Bounds<2> bounds;
  bounds.include(laser);
  ends_.clear();
  for (const Point2& point : points_in_robot) {
    ends_.push_back(frame.in_cells(T_map_robot * point));
    bounds.include(ends_.back());
  }
  tallies_->make_room(bounds);
  tallies_->count(laser, ends_);
}

OccupancyGrid GridBuilder::grid() const {
  const GridFrame& frame = tallies_->frame();
  if (tallies_->seen().empty())
    throw Error("no scan had a return to make a grid of", "GridBuilder::grid", "raise the range filter's max_range");
  const Point2 first = frame.first_cell(tallies_->seen());
  OccupancyGrid grid = frame.unknown_grid(first, frame.last_cell(tallies_->seen()));
  grid.probability.assign(grid.cells.size(), std::numeric_limits<float>::quiet_NaN());
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column) {
      const Point2 cell = first + Point2(column, row);
      const Tallies::Tally tally = tallies_->tally(cell);
      const double rays = static_cast<double>(tally.ended) + static_cast<double>(tally.passed);
      const bool is_behind = tally.passed == 0 && tallies_->is_outshone(cell, options_.occupied_share);
      if (rays == 0.0 || is_behind) continue;
      const double share = tally.ended / rays;
      const bool is_wall = share >= options_.occupied_share && !tallies_->is_outshone(cell, options_.occupied_share);
      const std::size_t index = grid.index({column, row});
      grid.probability[index] = static_cast<float>(share);
      grid.cells[index] = is_wall ? CellState::occupied : CellState::free;
    }
  return grid;
}

}  // namespace slamicp
