// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/simulation/floor_plan.hpp>

#include "simulation/polyline.hpp"

namespace slamicp {
namespace {

constexpr double outline_tolerance = 0.8;  // [cells]

/// The sides of a cell, counter-clockwise. The outline runs along side s in the direction of side s + 1, with what is
/// occupied to its left.
constexpr std::array<Cell, 4> outwards{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// One side of an occupied cell beyond which is none.
struct OutlineStep {
  Cell cell;
  std::size_t side = 0;
};

class OutlineTracer {
 public:
  explicit OutlineTracer(const OccupancyGrid& grid)
      : grid_(grid),
        air_(air_of(grid)),
        T_grid_map_(grid.T_map_grid.inverse()),
        walls_(wall_cells(grid)),
        traced_(grid.cells.size(), 0) {
    for (const WallCell& wall : walls_) points_.emplace(grid.index(wall.cell), wall.point);
  }

  bool has_walls() const noexcept { return !walls_.empty(); }

  void add_to(World& world) {
    for (const WallCell& wall : walls_)
      for (std::size_t side = 0; side < 4; ++side)
        if (is_seen({wall.cell, side}) && !is_traced({wall.cell, side})) trace({wall.cell, side}, world);
    for (const WallCell& wall : walls_)
      if (!in_lines_.contains(grid_.index(wall.cell))) world.pillars.push_back({wall.point, 0.5 * grid_.resolution});
  }

 private:
  /// A corner of an outline: its cell says which are the same.
  struct Corner {
    std::size_t cell;
    Point2 point;
  };

  static Cell beyond(const Cell& cell, std::size_t side) noexcept {
    return {cell.column + outwards[side % 4].column, cell.row + outwards[side % 4].row};
  }
  bool is_occupied(const Cell& cell) const noexcept { return grid_.at(cell) == CellState::occupied; }
  bool is_seen(const OutlineStep& step) const noexcept { return grid_.at(beyond(step.cell, step.side)) == air_; }
  bool is_traced(const OutlineStep& step) const noexcept {
    return (traced_[grid_.index(step.cell)] >> step.side & 1U) != 0;
  }
  Corner corner_in(const Cell& cell) const { return {grid_.index(cell), points_.at(grid_.index(cell))}; }

  /// Cells that touch at a corner belong together: no ray slips through between them.
  OutlineStep after(const OutlineStep& step) const noexcept {
    const Cell ahead = beyond(step.cell, step.side + 1);
    const Cell ahead_right = beyond(ahead, step.side);
    if (is_occupied(ahead_right)) return {ahead_right, (step.side + 3) % 4};
    if (is_occupied(ahead)) return {ahead, step.side};
    return {step.cell, (step.side + 1) % 4};
  }

  /// Follows an outline once round, and adds the parts of it that are seen and new.
  void trace(const OutlineStep& start, World& world) {
    std::vector<OutlineStep> round;
    for (OutlineStep step = start; !is_traced(step); step = after(step)) {
      traced_[grid_.index(step.cell)] |= static_cast<std::uint8_t>(1U << step.side);
      round.push_back(step);
    }
    const std::size_t first = beginning(round);
    std::rotate(round.begin(), round.begin() + static_cast<std::ptrdiff_t>(first), round.end());
    const bool is_closed = is_seen(round.front());
    if (is_closed) round.insert(round.begin(), round.back());
    std::vector<Corner> line;
    for (std::size_t k = 1; k < round.size(); ++k) add_step(round[k - 1], round[k], line, world);
    if (is_closed) add_step(round.back(), round[1], line, world);
    add_line(line, world);
  }

  void add_step(const OutlineStep& before, const OutlineStep& step, std::vector<Corner>& line, World& world) {
    if (!is_seen(step)) return add_line(line, world);
    if (is_seen(before) && is_inner_corner(before, step)) go_on(inner_corner(before, step), line, world);
    go_on(corner_in(step.cell), line, world);
  }

  /// Where two walls of a room meet no ray reaches the cell that they share.
  bool is_inner_corner(const OutlineStep& before, const OutlineStep& step) const noexcept {
    return step.side == (before.side + 3) % 4 && is_occupied(beyond(before.cell, before.side + 1));
  }
  Corner inner_corner(const OutlineStep& before, const OutlineStep& step) const {
    const Point2 from = T_grid_map_ * corner_in(before.cell).point;
    const Point2 to = T_grid_map_ * corner_in(step.cell).point;
    const bool is_along_x = before.side % 2 == 1;
    const Point2 meeting = is_along_x ? Point2(to.x(), from.y()) : Point2(from.x(), to.y());
    return {grid_.index(beyond(before.cell, before.side + 1)), grid_.T_map_grid * meeting};
  }

  void go_on(const Corner& to, std::vector<Corner>& line, World& world) {
    if (!line.empty() && line.back().cell == to.cell) return;
    const bool is_new = line.empty() || edges_.insert(std::minmax(line.back().cell, to.cell)).second;
    if (!is_new) add_line(line, world);  // a thin wall seen from its other side
    line.push_back(to);
  }

  /// Where an outline is best cut open: where it is not seen; else at the end of a thin wall; else at a corner.
  std::size_t beginning(const std::vector<OutlineStep>& round) const noexcept {
    std::size_t best = 0;
    int best_rank = 0;
    for (std::size_t k = 0; k < round.size(); ++k) {
      const OutlineStep& before = round[(k + round.size() - 1) % round.size()];
      const OutlineStep& behind = round[(k + 1) % round.size()];
      const bool turns_here = before.side != round[k].side;
      const bool is_end = before.cell == round[k].cell && behind.cell == round[k].cell;
      const int rank = !is_seen(round[k]) ? 3 : turns_here && is_end ? 2 : turns_here ? 1 : 0;
      if (rank <= best_rank) continue;
      best = k;
      best_rank = rank;
    }
    return best;
  }

  void add_line(std::vector<Corner>& line, World& world) {
    PointCloud2 corners;
    for (const Corner& corner : line) corners.push_back(corner.point);
    if (line.size() > 1)
      for (const Corner& corner : line) in_lines_.insert(corner.cell);
    corners = simplified(corners, outline_tolerance * grid_.resolution);
    for (std::size_t k = 1; k < corners.size(); ++k) world.walls.push_back({corners[k - 1], corners[k]});
    line.clear();
  }

  const OccupancyGrid& grid_;
  CellState air_;
  Pose2 T_grid_map_;
  std::vector<WallCell> walls_;
  std::unordered_map<std::size_t, Point2> points_;       // of the walls, by cell
  std::vector<std::uint8_t> traced_;                     // of each cell a bit a side
  std::set<std::pair<std::size_t, std::size_t>> edges_;  // from cell to cell
  std::unordered_set<std::size_t> in_lines_;             // cells
};

}  // namespace

World with_floor_plan(World world, const OccupancyGrid& grid) {
  if (const std::string problem = grid.problem(); !problem.empty())
    throw Error(problem, "OccupancyGrid", "make it with GridBuilder or load_occupancy_map");
  OutlineTracer tracer(grid);
  if (!tracer.has_walls()) throw Error("no cell is occupied", "floor plan", "give a map with walls");
  tracer.add_to(world);
  return world;
}

}  // namespace slamicp
