// SPDX-License-Identifier: Apache-2.0
#include "fuzz.hpp"
#include "io/occupancy_cells.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    const slamicp::OccupancyImage image = slamicp::parse_png(bytes, "fuzz");
    std::vector<std::string> warnings;
    for (const auto mode :
         {slamicp::OccupancyMode::trinary, slamicp::OccupancyMode::scale, slamicp::OccupancyMode::raw})
      if (!slamicp::cells_of(image, {.mode = mode}, warnings).problem().empty()) std::abort();
  });
}
