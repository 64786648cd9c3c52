// SPDX-License-Identifier: Apache-2.0
#include "fuzz.hpp"
#include "io/occupancy_cells.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    const slamicp::OccupancyImage image = slamicp::parse_pgm(bytes, "fuzz");
    // What was read can be written, and reads back as the same cells.
    std::vector<std::string> warnings;
    const slamicp::OccupancyGrid grid = slamicp::cells_of(image, {}, warnings);
    const slamicp::OccupancyImage again = slamicp::parse_pgm(slamicp::pgm_bytes(grid), "fuzz again");
    if (slamicp::cells_of(again, {}, warnings).cells != grid.cells) std::abort();
  });
}
