// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <slamicp/search/cell_index.hpp>

#include "support/clouds.hpp"

namespace slamicp::test {

/// Any cells that CellOptions allow: small and large, reaching little or as far as they can.
inline CellOptions any_cells(Random& random) {
  CellOptions cells;
  cells.cell = random.chance(0.3) ? 0.05 : random.uniform(0.01, 0.2);
  cells.reach = cells.cell * (random.chance(0.2) ? 15.0 : random.uniform(0.2, 14.0));
  cells.eager = random.chance(0.7);
  return cells;
}

/// The place `name` cells from the origin, as an index cuts the plane: a product of two doubles, no rounding.
inline double border(const CellIndex& index, int name) { return name * index.cell(); }

/// At the origin, 500 m or 5 km from it; now and then on the corner of a tile.
inline Point2 any_center(Random& random, double tile) {
  const double distances[] = {0.0, 500.0, 5000.0};
  Point2 center = random.point<2>(distances[random.integer(0, 2)]);
  if (random.chance(0.5)) center = (center / tile).array().round() * tile;
  return center;
}

/// An unkind cloud as large as a few tiles, so that cells have neighbours to list; some points lie on the borders of
/// cells and on the corners of tiles.
inline PointCloud2 cloud_of_tiles(Random& random, const CellIndex& grid, int size, const Point2& center) {
  const double half_width = random.uniform(3.0, 32.0) * grid.cell();
  PointCloud2 cloud = unkind_cloud<2>(random, size);
  for (Point2& point : cloud) {
    point = center + 0.5 * half_width * point;
    if (!random.chance(0.1) || !is_finite<2>(point)) continue;
    const double step = random.chance(0.2) ? grid.tile() : grid.cell();
    point[0] = std::round(point[0] / step) * step;
    if (random.chance(0.5)) point[1] = std::round(point[1] / step) * step;
  }
  return cloud;
}

/// On a point, beside one, on the border of a cell or of a tile or a hair beside it, anywhere, far away, no number.
inline Point2 any_place(Random& random, const CellIndex& grid, const PointCloud2& cloud, const Point2& center) {
  Point2 place = center + random.point<2>(40.0 * grid.cell());
  const int kind = random.integer(0, 19);
  if (kind < 6 && !cloud.empty()) {
    const Point2& point = cloud[static_cast<std::size_t>(random.integer(0, static_cast<int>(cloud.size()) - 1))];
    place = kind == 0 ? point : point + random.point<2>(grid.cell() * random.uniform(0.0, 3.0));
  } else if (kind < 14) {
    const double step = kind < 10 ? grid.cell() : grid.tile();
    const double beside[] = {0.0, 1e-9, -1e-9, 1e-12, -1e-12};
    for (int axis = 0; axis < 2; ++axis)
      if (axis != kind % 3) place[axis] = std::round(place[axis] / step) * step + beside[random.integer(0, 4)];
  } else if (kind == 14) {
    place = center + random.point<2>(random.chance(0.5) ? 1e3 : 1e12);
  } else if (kind == 15) {
    const double odd[] = {nan, infinity, -infinity, 1e300};
    place[random.integer(0, 1)] = odd[random.integer(0, 3)];
  }
  return place;
}

/// Less than the cells reach, as far, farther, everywhere.
inline double any_reach(Random& random, const CellIndex& index) {
  const double reach = index.cell_options().reach;
  switch (random.integer(0, 9)) {
    case 0:
      return reach;
    case 1:
      return std::nextafter(reach, infinity);
    case 2:
      return 1e9;
    case 3:
      return random.uniform(1.0, 5.0) * reach;
    default:
      return random.uniform(0.0, 1.0) * reach;
  }
}

/// An index that was not made for looking at: where it cuts the plane is what counts.
inline CellIndex grid_of(const CellOptions& cells) { return {PointCloud2{}, SurfaceOptions{}, cells}; }

/// Tables by tile, all that lie around some points and a margin of two tiles.
struct Tables {
  int x = 0, y = 0, width = 0;
  std::vector<const CellTable*> tables;

  Tables(const CellIndex& index, const Point2& lower, const Point2& upper) {
    const double tile = index.tile();
    x = static_cast<int>(std::floor(lower.x() / tile)) - 2;
    y = static_cast<int>(std::floor(lower.y() / tile)) - 2;
    width = static_cast<int>(std::max(std::floor(upper.x() / tile) - x, std::floor(upper.y() / tile) - y)) + 3;
    tables.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(width));
    index.tables(x, y, width, tables);
  }
  explicit Tables(const CellIndex& index, const Bounds<2>& bounds) : Tables(index, bounds.lower, bounds.upper) {}

  const CellTable* at(int column, int row) const {
    return tables[static_cast<std::size_t>((row - y) * width + column - x)];
  }
  std::size_t count(const CellTable& kind) const {
    return static_cast<std::size_t>(std::count(tables.begin(), tables.end(), &kind));
  }
};

}  // namespace slamicp::test
