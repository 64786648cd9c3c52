// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "refusal.hpp"

namespace slamicp::c {

/// Structs that cross the interface begin with their size. One that is larger than ours comes from a newer header: what
/// we do not know of it must be zero, else it asks for something that we cannot do.
inline constexpr std::size_t largest_struct = 65536;

template <class T>
void check_size(const T* given, const char* name) {
  need(given, name);
  const std::size_t size = given->size;
  if (size < sizeof(T) || size > largest_struct)
    throw Refusal(SLAMICP_BAD_SIZE, std::string(name) + " has not been through its _init function");
  const char* const bytes = reinterpret_cast<const char*>(given);
  if (std::any_of(bytes + sizeof(T), bytes + size, [](char byte) { return byte != 0; }))
    throw Refusal(SLAMICP_BAD_SIZE, std::string(name) + " asks for something that this library is too old for");
}

/// What was given, or the defaults where it is NULL.
template <class T>
T read_or(const T* given, const T& defaults, const char* name) {
  if (given == nullptr) return defaults;
  check_size(given, name);
  return *given;
}

/// For the _init functions.
template <class T>
slamicp_status initialize(T* it, std::size_t size, const T& defaults, const char* name) noexcept {
  return guarded(SLAMICP_INTERNAL, [&] {
    need(it, name);
    if (size < sizeof(T) || size > largest_struct)
      throw Refusal(SLAMICP_BAD_SIZE, std::string("size is not that of ") + name + "; give sizeof");
    std::memset(static_cast<void*>(it), 0, size);
    *it = defaults;
    it->size = size;
  });
}

/// Fills what the caller has checked with check_size.
template <class T>
void write(T* to, T what) noexcept {
  what.size = to->size;
  *to = what;
}

}  // namespace slamicp::c
