// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <slamicp/io/spelling.hpp>

namespace slamicp::text {

std::size_t spelling_distance(std::string_view one, std::string_view other) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(other.size() + 1);
  for (std::size_t k = 0; k <= other.size(); ++k) last[k] = k;
  for (std::size_t row = 1; row <= one.size(); ++row) {
    std::vector<std::size_t> now(other.size() + 1, row);
    for (std::size_t k = 1; k <= other.size(); ++k) {
      const std::size_t change = one[row - 1] == other[k - 1] ? 0 : 1;
      now[k] = std::min({last[k] + 1, now[k - 1] + 1, last[k - 1] + change});
      const bool swapped = row > 1 && k > 1 && one[row - 1] == other[k - 2] && one[row - 2] == other[k - 1];
      if (swapped) now[k] = std::min(now[k], before_last[k - 2] + 1);
    }
    before_last = std::move(last);
    last = std::move(now);
  }
  return last.back();
}

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
  constexpr std::size_t longest = 64;  // what is longer is no misspelt name
  if (word.empty() || word.size() > longest) return {};
  std::string_view nearest;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view name : names) {
    const std::size_t distance = spelling_distance(word, name);
    const bool is_start = word.size() > 2 && (name.starts_with(word) || word.starts_with(name));
    const std::size_t rank = is_start ? std::min<std::size_t>(distance, 1) : distance;
    if (rank >= least) continue;
    least = rank;
    nearest = name;
  }
  return nearest;
}

}  // namespace slamicp::text
