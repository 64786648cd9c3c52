// SPDX-License-Identifier: Apache-2.0
#include <slamicp/io/carmen_log.hpp>

#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    const slamicp::ScanLog log = slamicp::parse_carmen_log(bytes, "fuzz");
    // What was read can be written, or is refused in words; what was written can be read.
    const std::string text = slamicp::carmen_log_text(log.scans);
    if (slamicp::parse_carmen_log(text, "fuzz again").size() != log.size()) std::abort();
  });
}
