// SPDX-License-Identifier: Apache-2.0
// Which points match nothing.
#pragma once

#include "registration/pass/nearest-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

/// What a single point's cell, or its nearest candidate, says about the threshold.
SLAMICP_PASS bool is_outlier(const OutlierRequest& request, const CellTable* table, std::uint32_t word,
                             std::uint32_t point, bool* is_unsure) {
  *is_unsure = false;
  if ((word >> 26U) >= request.sure_outside) return true;
  const std::uint32_t count = word & 63U;
  *is_unsure = count == CellTable::no_answer;
  if (*is_unsure) return true;
  const std::uint32_t squared = find_nearest(places_of(table) + first_of(word), count, point).squared & ~which_bits;
  if (squared < request.threshold.sure) return false;
  *is_unsure = request.looks_farther || squared <= request.threshold.beyond;
  return true;
}

SLAMICP_PASS std::uint32_t outlier_pass(const OutlierRequest& request) noexcept {
  std::uint32_t found = 0;
  for_each_block({request.scan, 1}, request.window, request.place, [&](const Block& block) {
    for (std::uint32_t i = 0; i < block.count; ++i) {
      const CellTable* table = request.window.tables[block.tile[i]];
      const std::uint32_t word = table->cells[block.cell[i]];
      if (HWY_LIKELY(((word >> 20U) & 63U) <= request.sure_inside)) continue;
      bool is_unsure;
      if (!(block.px[i] < absent) || !is_outlier(request, table, word, block.place[i], &is_unsure)) continue;
      request.found[found++] = (block.begin + i) | (is_unsure ? unsure : 0U);
    }
  });
  return found;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
