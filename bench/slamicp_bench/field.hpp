// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contender.hpp"

namespace slamicp::bench {

/// A peer that this program was built without.
struct Missing {
  std::string name;
  std::string why;
  std::string mend;
};

/// Who runs, and who cannot.
struct Field {
  std::vector<Contender> contenders;
  std::vector<Missing> missing;
};

/// Every time is also given as a multiple of this one's: it hands out what the paper's agent needs.
inline constexpr const char* reference_name = "ours_outliers";

Field whole_field();

/// Those that the words name, or whose names begin with a word that is none; all for no words. Throws
/// std::invalid_argument for a word that fits none.
Field chosen(const Field& field, std::span<const std::string> words);

// One file each.
std::vector<Contender> ours();
std::vector<Contender> original_agents();
std::vector<Contender> improved_agents();
std::vector<Contender> pcl_contenders();
std::vector<Contender> mrpt_contenders();

}  // namespace slamicp::bench
