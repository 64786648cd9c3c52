// SPDX-License-Identifier: Apache-2.0
#include <slamicp/io/relations_file.hpp>

#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) { slamicp::parse_relations(bytes, "fuzz"); });
}
