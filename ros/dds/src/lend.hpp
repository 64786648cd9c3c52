// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

// A message borrows its texts and lists: dds_write has copied all of it when it returns. DDS's C structs have no const.
namespace slamicp::node {

inline char* lend(const std::string& text) { return const_cast<char*>(text.c_str()); }
inline char* lend(const char* text) { return const_cast<char*>(text); }

template <class Sequence, class Element>
void lend(const std::vector<Element>& list, Sequence& sequence) {
  sequence._maximum = sequence._length = static_cast<std::uint32_t>(list.size());
  sequence._buffer = const_cast<Element*>(list.data());
}

}  // namespace slamicp::node
