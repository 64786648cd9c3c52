// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <memory>

#include "conversion.hpp"
#include "handles.hpp"
#include "sized.hpp"

namespace slamicp::c {
namespace {

slamicp_map_options default_map_options() noexcept {
  const SurfaceOptions surfaces;
  const CellOptions cells;
  return {sizeof(slamicp_map_options),
          surfaces.neighbours,
          surfaces.min_neighbours,
          surfaces.radius,
          cells.cell,
          cells.reach,
          surfaces.scatter};
}

void refuse_map_options(const std::string& why) { throw Refusal(SLAMICP_BAD_OPTIONS, why); }

SurfaceOptions surfaces_from(const slamicp_map_options& options) {
  if (options.neighbours < 0 || options.neighbours > 64)
    refuse_map_options("neighbours must lie between 0 (no lines) and 64; 12 is the default");
  if (options.neighbours > 0 && (options.min_neighbours < 3 || options.min_neighbours > options.neighbours))
    refuse_map_options("min_neighbours must lie between 3 and neighbours; 5 is the default");
  if (!(options.radius > 0.0) || !std::isfinite(options.radius))
    refuse_map_options("radius must be a length above 0 m; 0.5 m is the default");
  if (!(options.scatter > 0.0))
    refuse_map_options("scatter must be above 0; 1.3 is the default, infinity trusts every line");
  SurfaceOptions made;
  made.neighbours = options.neighbours;
  made.min_neighbours = options.min_neighbours;
  made.radius = options.radius;
  made.scatter = options.scatter;
  return made;
}

CellOptions cells_from(const slamicp_map_options& options) {
  CellOptions made;
  made.cell = options.cell;
  made.reach = options.reach;
  if (const std::string problem = made.problem(); !problem.empty()) refuse_map_options(problem);
  return made;
}

slamicp_map make_map(int32_t dimension, const double* points, std::size_t count, const slamicp_map_options& options) {
  if (dimension == 2)
    return {PointMap2::create(to_cloud<2>(view_of_some<2>(points, count, "points")), surfaces_from(options),
                              cells_from(options)),
            nullptr};
  if (dimension == 3)
    return {nullptr, PointMap3::create(to_cloud<3>(view_of_some<3>(points, count, "points")), surfaces_from(options))};
  throw Refusal(SLAMICP_BAD_POINTS, "the dimension must be 2 or 3");
}

Neighbour nearest(const slamicp_map& map, const double* query, double reach) {
  if (map.plane) return map.plane->indexed().nearest(view_of<2>(query, 1, "query").front(), reach);
  return map.space->indexed().nearest(view_of<3>(query, 1, "query").front(), reach);
}

}  // namespace
}  // namespace slamicp::c

using namespace slamicp;
using namespace slamicp::c;

slamicp_status slamicp_map_options_init(slamicp_map_options* options, size_t size) {
  return initialize(options, size, default_map_options(), "options");
}

slamicp_status slamicp_map_create(int32_t dimension, const double* points, size_t count,
                                  const slamicp_map_options* options, slamicp_map** map) {
  return guarded(SLAMICP_BAD_POINTS, [&] {
    need(map, "map");
    const slamicp_map_options chosen = read_or(options, default_map_options(), "options");
    *map = std::make_unique<slamicp_map>(make_map(dimension, points, count, chosen)).release();
  });
}

slamicp_status slamicp_map_with_added(const slamicp_map* map, const double* points, size_t count, slamicp_map** grown) {
  return guarded(SLAMICP_BAD_POINTS, [&] {
    need(map, "map");
    need(grown, "grown");
    auto made = std::make_unique<slamicp_map>();
    if (map->plane)
      made->plane = map->plane->with_added(view_of<2>(points, count, "points"));
    else
      made->space = map->space->with_added(view_of<3>(points, count, "points"));
    *grown = made.release();
  });
}

void slamicp_map_free(slamicp_map* map) { delete map; }

int32_t slamicp_map_dimension(const slamicp_map* map) { return map == nullptr ? 0 : map->plane ? 2 : 3; }

size_t slamicp_map_size(const slamicp_map* map) {
  if (map == nullptr) return 0;
  return map->plane ? map->plane->size() : map->space->size();
}

const double* slamicp_map_points(const slamicp_map* map) {
  if (map == nullptr) return nullptr;
  return map->plane ? map->plane->points().front().data() : map->space->points().front().data();
}

slamicp_status slamicp_map_nearest(const slamicp_map* map, const double* query, double reach, int32_t* index,
                                   double* distance) {
  return guarded(SLAMICP_BAD_POINTS, [&] {
    need(map, "map");
    need(query, "query");
    need(index, "index");
    need(distance, "distance");
    if (!(reach > 0.0) || !std::isfinite(reach)) refuse_map_options("reach must be a length above 0 m");
    const Neighbour found = nearest(*map, query, reach);
    *index = found.index;
    *distance = std::sqrt(found.squared_distance);
  });
}
