// SPDX-License-Identifier: Apache-2.0
#include "field.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace slamicp::bench {
namespace {

void add(std::vector<Contender>& all, std::vector<Contender> some) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
}

/// A word that is a name means that one; another means all that begin with it.
template <class Named>
bool fits(const Named& one, const std::string& word, bool is_name) {
  return is_name ? one.name == word : one.name.starts_with(word);
}

template <class Named>
bool has(const std::vector<Named>& all, const std::string& word, bool is_name) {
  return std::any_of(all.begin(), all.end(), [&](const Named& one) { return fits(one, word, is_name); });
}

std::invalid_argument no_such_contender(const Field& field, const std::string& word) {
  std::string known;
  for (const Contender& contender : field.contenders) known += " " + contender.name;
  for (const Missing& missing : field.missing) known += " " + missing.name;
  return std::invalid_argument("there is no contender '" + word + "'; give names, or how they begin:" + known);
}

}  // namespace

Field whole_field() {
  Field field;
  add(field.contenders, ours());
  add(field.contenders, original_agents());
  add(field.contenders, improved_agents());
#ifdef SLAMICP_BENCH_WITH_PCL
  add(field.contenders, pcl_contenders());
#else
  field.missing.push_back(
      {"pcl", "PCL was not found when this was configured", "apt-get install libpcl-dev, configure anew"});
#endif
#ifdef SLAMICP_BENCH_WITH_MRPT
  add(field.contenders, mrpt_contenders());
#else
  field.missing.push_back(
      {"mrpt", "MRPT was not found when this was configured", "apt-get install libmrpt-slam-dev, configure anew"});
#endif
  return field;
}

Field chosen(const Field& field, std::span<const std::string> words) {
  if (words.empty()) return field;
  const auto is_chosen = [&](const auto& one) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return fits(one, word, has(field.contenders, word, true) || has(field.missing, word, true));
    });
  };
  for (const std::string& word : words)
    if (!has(field.contenders, word, false) && !has(field.missing, word, false)) throw no_such_contender(field, word);
  Field some;
  std::copy_if(field.contenders.begin(), field.contenders.end(), std::back_inserter(some.contenders), is_chosen);
  std::copy_if(field.missing.begin(), field.missing.end(), std::back_inserter(some.missing), is_chosen);
  return some;
}

}  // namespace slamicp::bench
