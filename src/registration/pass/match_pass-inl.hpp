// SPDX-License-Identifier: Apache-2.0
// The match of every point.
#pragma once

#include "registration/pass/nearest-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

/// The numbers of the points nearest to those of the block, no_match or ask: what is nearest of the first 16 places of
/// a cell has to be in its list, and to have no rival there.
SLAMICP_PASS void match_block(const MatchRequest& request, Block& block) {
  const D d;
  const DU du;
  const CellPlace* places[block_size];
  std::uint32_t words[block_size];
  std::int32_t numbers[block_size];
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const CellTable* table = request.window.tables[block.tile[i]];
    words[i] = table->cells[block.cell[i]];
    places[i] = places_of(table) + first_of(words[i]);
    const Found found = find_nearest(places[i], places_at_once, block.place[i]);
    block.squared[i] = found.squared & ~which_bits;
    const bool is_listed = found.which < (words[i] & 63U);
    const std::int32_t number = line_of(table, first_of(words[i]) + found.which)->number;
    numbers[i] = is_listed ? number : no_match;
  }
  close_block(block);
  // (d + margin)^2, and what the numbers in the lowest bits can add.
  HWY_ALIGN std::uint32_t bounds[block_size];
  const V margin = hn::Set(d, request.margin);
  for (std::uint32_t k = 0; k < block.count; k += lanes) {
    const V d2 = hn::ConvertTo(d, hn::BitCast(DI(), hn::Load(du, block.squared + k)));
    const V more =
        hn::MulAdd(margin, hn::MulAdd(hn::Set(d, 2.0F), hn::Sqrt(d2), margin), hn::Set(d, 2.0F * which_bits));
    const V bound = hn::Min(hn::Add(d2, more), hn::Set(d, 2e9F));
    hn::Store(hn::BitCast(du, hn::ConvertTo(DI(), bound)), du, bounds + k);
  }
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const std::uint32_t count = words[i] & 63U;
    const std::uint32_t listed = (std::uint32_t{1} << (count & 31U)) - 1U;
    const std::uint32_t rivals = places_below(places[i], block.place[i], bounds[i]) & listed;
    const bool has_rival = (rivals & (rivals - 1U)) != 0;
    const bool is_near = block.squared[i] < request.reach.sure;
    std::int32_t number = is_near && rivals != 0 ? numbers[i] : no_match;
    const bool is_edge = !is_near && block.squared[i] <= request.reach.beyond;
    if (HWY_UNLIKELY((is_near && (has_rival || numbers[i] == no_match)) || is_edge || count > places_at_once))
      number = block.px[i] < absent ? ask : no_match;  // more than 16, or no answer
    request.numbers[block.begin + i] = number;
  }
}

/// Distances to the matches, with the operations in the order that the scalar code has them: the same bits.
SLAMICP_PASS void measure_block(const MatchRequest& request, std::size_t begin, std::size_t count) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t width = hn::MaxLanes(d);
  HWY_ALIGN double map_xy[2 * block_size];
  HWY_ALIGN double scan_xy[2 * block_size];
  HWY_ALIGN double squared[block_size], distance[block_size];
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t number = request.numbers[begin + i];
    hwy::CopyBytes<16>(request.map_points + 2 * static_cast<std::ptrdiff_t>(number < 0 ? 0 : number), map_xy + 2 * i);
    hwy::CopyBytes<16>(request.scan_xy + 2 * (begin + i), scan_xy + 2 * i);
  }
  for (std::size_t i = 2 * count; i < std::size_t{2} * block_size; ++i) map_xy[i] = scan_xy[i] = 0.0;
  const auto cosine = hn::Set(d, request.cosine);
  const auto sine = hn::Set(d, request.sine);
  for (std::size_t i = 0; i < count; i += width) {
    hn::Vec<hn::CappedTag<double, 8>> x, y, mx, my;
    hn::LoadInterleaved2(d, scan_xy + 2 * i, x, y);
    hn::LoadInterleaved2(d, map_xy + 2 * i, mx, my);
    const auto in_map_x = hn::Add(hn::Sub(hn::Mul(cosine, x), hn::Mul(sine, y)), hn::Set(d, request.translation_x));
    const auto in_map_y = hn::Add(hn::Add(hn::Mul(sine, x), hn::Mul(cosine, y)), hn::Set(d, request.translation_y));
    const auto dx = hn::Sub(mx, in_map_x);
    const auto dy = hn::Sub(my, in_map_y);
    const auto square = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    hn::Store(square, d, squared + i);
    hn::Store(hn::Sqrt(square), d, distance + i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    request.squared_distances[begin + i] = squared[i];
    request.distances[begin + i] = distance[i];
  }
}

SLAMICP_PASS void match_pass(const MatchRequest& request) noexcept {
  for_each_block({request.scan, 1}, request.window, request.place, [&](Block& block) {
    match_block(request, block);
    measure_block(request, block.begin, block.count);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
