// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <slamicp/error.hpp>

namespace slamicp::fuzz {

/// Runs a reader on the bytes. An Error is a fine answer, if it says what and where; all else is a finding.
template <class Read>
int run(const std::uint8_t* data, std::size_t size, Read read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const Error& error) {
    if (error.problem().empty() || error.where().empty() || error.mend().empty()) std::abort();
  }
  return 0;
}

}  // namespace slamicp::fuzz
