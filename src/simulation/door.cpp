// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <slamicp/simulation/world.hpp>

namespace slamicp {
namespace {

constexpr double gap_touch = 1e-6;  // what only touches a gap is not cut [m]

/// The part of a line between two shares of it.
struct SharedPart {
  double from = 0.0;
  double to = 1.0;
};

/// The gap of a door, along x from its hinge to its latch, in its own frame.
class DoorGap {
 public:
  explicit DoorGap(const Door& door) {
    const Point2 across = door.latch - door.hinge;
    width_ = across.norm();
    T_map_gap_ = {door.hinge.x(), door.hinge.y(), std::atan2(across.y(), across.x())};
    T_gap_map_ = T_map_gap_.inverse();
  }

  /// What of the wall lies outside the gap.
  void cut(const Segment& wall, std::vector<Segment>& left) {
    const Segment in_gap{T_gap_map_ * wall.a, T_gap_map_ * wall.b};
    const std::optional<SharedPart> core = part_inside(in_gap, gap_touch);
    if (!core || (core->to - core->from) * (wall.b - wall.a).norm() <= gap_touch) {
      left.push_back(wall);
      return;
    }
    const SharedPart part = part_inside(in_gap, 0.0).value_or(*core);
    const Point2 along = wall.b - wall.a;
    if (part.from * along.norm() > gap_touch) left.push_back({wall.a, wall.a + part.from * along});
    if ((1.0 - part.to) * along.norm() > gap_touch) left.push_back({wall.a + part.to * along, wall.b});
    for (const double share : {part.from, part.to}) note(in_gap.a + share * (in_gap.b - in_gap.a));
  }

  /// The reveals: from face to face of the wall, at both ends of the gap.
  void add_reveals(std::vector<Segment>& walls) const {
    for (const auto& [x, span] : {std::pair(0.0, at_hinge_), std::pair(width_, at_latch_)})
      if (span.to - span.from > gap_touch)
        walls.push_back({T_map_gap_ * Point2(x, span.from), T_map_gap_ * Point2(x, span.to)});
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Liang and Barsky 1984, "A new concept and method for line clipping".
  std::optional<SharedPart> part_inside(const Segment& line, double margin) const noexcept {
    SharedPart part;
    const Point2 along = line.b - line.a;
    const Point2 lower(margin, -door_gap_depth + margin);
    const Point2 upper(width_ - margin, door_gap_depth - margin);
    for (int axis = 0; axis < 2; ++axis) {
      if (along[axis] == 0.0) {
        if (line.a[axis] < lower[axis] || line.a[axis] > upper[axis]) return std::nullopt;
        continue;
      }
      const double first = (lower[axis] - line.a[axis]) / along[axis];
      const double second = (upper[axis] - line.a[axis]) / along[axis];
      part.from = std::max(part.from, std::min(first, second));
      part.to = std::min(part.to, std::max(first, second));
    }
    return part.from < part.to ? std::optional(part) : std::nullopt;
  }

  void note(const Point2& cut) noexcept {
    for (auto& [x, span] : {std::pair<double, SharedPart&>(0.0, at_hinge_), {width_, at_latch_}}) {
      if (std::abs(cut.x() - x) > gap_touch) continue;
      span.from = std::min(span.from, cut.y());
      span.to = std::max(span.to, cut.y());
    }
  }

  double width_ = 0.0;
  Pose2 T_map_gap_;
  Pose2 T_gap_map_;
  SharedPart at_hinge_{infinity, -infinity};  // where walls were cut, across the gap [m]
  SharedPart at_latch_{infinity, -infinity};
};

}  // namespace

World with_door(World world, Door door) {
  DoorGap gap(door);
  std::vector<Segment> walls;
  walls.reserve(world.walls.size());
  for (const Segment& wall : world.walls) gap.cut(wall, walls);
  gap.add_reveals(walls);
  world.walls = std::move(walls);
  world.doors.push_back(std::move(door));
  return world;
}

}  // namespace slamicp
