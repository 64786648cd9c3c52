// SPDX-License-Identifier: Apache-2.0
#include <slamicp/io/occupancy_map_file.hpp>

#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    const slamicp::OccupancyMapHeader header = slamicp::parse_occupancy_yaml(bytes, "fuzz");
    const bool is_sane = header.resolution > 0.0 && header.T_map_grid.is_finite() &&
                         header.occupied_threshold > header.free_threshold && !header.image.empty();
    if (!is_sane) std::abort();
  });
}
