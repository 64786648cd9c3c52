// SPDX-License-Identifier: Apache-2.0
#include "fuzz.hpp"
#include "io/rosbag2_database.hpp"
#include "visitor.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    slamicp::fuzz::Visitor visitor;
    slamicp::read_rosbag2_database(std::string(bytes), "fuzz", visitor);
  });
}
