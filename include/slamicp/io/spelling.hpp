// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace slamicp::text {

/// How many letters must be added, taken away or changed to make one word of the other, or swapped with the next
/// (Damerau 1964). O(length^2).
std::size_t spelling_distance(std::string_view one, std::string_view other);

/// The name that was probably meant; empty where none is near.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

}  // namespace slamicp::text
