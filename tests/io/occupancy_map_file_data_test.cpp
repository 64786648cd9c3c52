// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/io/occupancy_map_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::occupancy_map_file_data_test {
namespace {

/// The counts are those of an independent reader, tests/apps/map_server_test.py.
TEST(OccupancyMapFileData, PublicMaps) {
  struct Case {
    const char* name;
    const char* format;
    int width, height;
    std::size_t occupied, free, walls, warnings;
  };
  for (const auto& [name, format, width, height, occupied, free, walls, warnings] :
       {Case{"levinelobby", "PGM P2", 692, 836, 479583, 98912, 4002, 0},
        Case{"mac_1st_floor_final", "PGM P5", 903, 1706, 16871, 1523647, 12815, 1},  // unknown read as free
        Case{"stata_basement", "PNG RGB, 8 bit", 1730, 1300, 18384, 310278, 8173, 1},
        Case{"willow-2010-02-18-0.10", "PGM P5", 566, 608, 544, 109207, 499, 1}}) {
    SLAMICP_NEEDS_DATA(path, std::string("maps_localization/") + name + ".yaml");
#ifndef SLAMICP_WITH_LIBPNG
    if (std::string(format).starts_with("PNG")) continue;
#endif
    SCOPED_TRACE(name);
    const OccupancyMap map = load_occupancy_map(path);
    const CellCounts counts = count_cells(map.grid);
    EXPECT_EQ(map.format, format);
    EXPECT_EQ(map.grid.width, width);
    EXPECT_EQ(map.grid.height, height);
    EXPECT_EQ(counts.occupied, occupied);
    EXPECT_EQ(counts.free, free);
    EXPECT_EQ(counts.occupied + counts.free + counts.unknown, map.grid.cells.size());
    EXPECT_EQ(wall_points(map.grid).size(), walls);
    EXPECT_EQ(map.warnings.size(), warnings);
  }
}

TEST(OccupancyMapFileData, ATurnedOrigin) {
#ifndef SLAMICP_WITH_LIBPNG
  GTEST_SKIP() << "built without libpng";
#endif
  SLAMICP_NEEDS_DATA(path, "maps_localization/stata_basement.yaml");
  const OccupancyGrid grid = load_occupancy_map(path).grid;
  EXPECT_EQ(grid.T_map_grid.theta, 3.14);
  // Half a turn: the map lies to the left of and below its origin.
  for (const Point2& point : wall_points(grid)) {
    EXPECT_LT(point.x(), 25.9 + 0.3);
    EXPECT_LT(point.y(), 48.5 + 0.3);
  }
}

}  // namespace
}  // namespace slamicp::occupancy_map_file_data_test
