// SPDX-License-Identifier: Apache-2.0
#include <slamicp/io/ranges_csv.hpp>

#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) { slamicp::parse_ranges_csv(bytes, "fuzz"); });
}
