// SPDX-License-Identifier: Apache-2.0
#include "fuzz.hpp"
#include "visitor.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    slamicp::fuzz::Visitor visitor;
    slamicp::read_mcap(bytes, "fuzz", visitor);
  });
}
