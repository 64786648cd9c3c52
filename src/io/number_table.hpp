// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <slamicp/error.hpp>

#include "io/text.hpp"

namespace slamicp {

/// Reads a text of N finite numbers a line and hands each line on; skips empty lines and '#' comments.
/// @param form  what a line must look like, for messages: "stamp x y z qx qy qz qw"
template <std::size_t N, class Take>
void read_number_table(std::string_view text, const std::string& name, const std::string& form, Take&& take) {
  text::Lines lines(text, name);
  while (lines.next()) {
    text::Tokens tokens(lines.line());
    std::array<double, N> numbers{};
    std::size_t count = 0;
    bool is_comment = false;
    for (std::string_view token; !is_comment && tokens.next(token); ++count) {
      is_comment = count == 0 && token.starts_with('#');
      if (is_comment || count >= N) continue;
      const std::optional<double> number = text::to_number<double>(token);
      if (!number || !std::isfinite(*number))
        throw Error("value " + std::to_string(count + 1) + " is not a number: " + text::quoted(token), lines.where(),
                    "write " + form);
      numbers[count] = *number;
    }
    if (is_comment || count == 0) continue;
    if (count != N)
      throw Error(text::count_of(count, "value") + ", not " + std::to_string(N), lines.where(), "write " + form);
    take(numbers, lines);
  }
}

}  // namespace slamicp
