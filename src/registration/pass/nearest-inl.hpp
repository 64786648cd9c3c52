// SPDX-License-Identifier: Apache-2.0
// The nearest of a cell's candidates, several at a time.
#pragma once

#include "registration/pass/block-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

// Candidates are compared by their squared distance in whole units, whose lowest four bits say which one it is.
constexpr std::uint32_t which_bits = 15;
constexpr std::uint32_t far = 0x7FFFFFF0U;  // a squared distance beyond all
constexpr std::uint32_t places_at_once = 16;

struct Found {
  std::uint32_t squared;
  std::uint32_t which;  // from the first of the list
};

#if HWY_TARGET != HWY_SCALAR

/// The least lane.
template <class Tag>
SLAMICP_PASS std::uint32_t least(Tag, hn::Vec<Tag> v) {
  if constexpr (hn::MaxLanes(Tag()) > 4) {
    const hn::Half<Tag> half;
    return least(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  } else {
    const auto pairs = hn::Min(v, hn::Shuffle1032(v));
    return hn::GetLane(hn::Min(pairs, hn::Shuffle2301(pairs)));
  }
}

/// Squared distances of the places from `first` on, with the number of each in the lowest bits.
template <std::uint32_t first>
SLAMICP_PASS VU squared_distances(const CellPlace* places, VU point) {
  const DI di;
  const DU du;
  const hn::Repartition<std::int16_t, D> d16;
  const auto all = hn::LoadU(d16, reinterpret_cast<const std::int16_t*>(places + first));
  const auto off = hn::SaturatedSub(all, hn::BitCast(d16, point));
  VI other = hn::Zero(di);
  const VI products = hn::ReorderWidenMulAccumulate(di, off, off, hn::Zero(di), other);
  const VU squared = hn::BitCast(du, hn::RearrangeToOddPlusEven(products, other));
  return hn::Or(hn::AndNot(hn::Set(du, which_bits), squared), hn::Iota(du, first));
}

/// The least of the first groups of places, lane by lane.
template <std::uint32_t vectors>
SLAMICP_PASS VU least_of(const CellPlace* places, VU point) {
  const VU last = squared_distances<(vectors - 1) * lanes>(places, point);
  if constexpr (vectors == 1)
    return last;
  else
    return hn::Min(least_of<vectors - 1>(places, point), last);
}

/// The nearest of the first 16 places.
SLAMICP_PASS std::uint32_t nearest_of_first(const CellPlace* places, std::uint32_t point) {
  const DU du;
  return least(du, least_of<places_at_once / lanes>(places, hn::Set(du, point)));
}

/// Which of the first 16 places have a squared distance below `bound`, one bit each.
SLAMICP_PASS std::uint32_t places_below(const CellPlace* places, std::uint32_t point, std::uint32_t bound) {
  const DU du;
  const DI di;
  const VU at = hn::Set(du, point);
  const VI limit = hn::Set(di, static_cast<std::int32_t>(bound));
  const auto bits_of = [&](VU squared) {
    HWY_ALIGN std::uint8_t stored[8] = {};
    hn::StoreMaskBits(di, hn::Lt(hn::BitCast(di, squared), limit), stored);
    std::uint32_t bits;
    hwy::CopyBytes<4>(stored, &bits);
    return bits;
  };
  std::uint32_t bits = bits_of(squared_distances<0>(places, at));
  if constexpr (lanes < 16) bits |= bits_of(squared_distances<lanes % 16>(places, at)) << lanes % 16;
  if constexpr (lanes < 8) {
    bits |= bits_of(squared_distances<2 * lanes % 16>(places, at)) << 2 * lanes % 16;
    bits |= bits_of(squared_distances<3 * lanes % 16>(places, at)) << 3 * lanes % 16;
  }
  return bits;
}

#else  // one lane: candidates one by one

/// Half the squared distance: the whole may not fit.
SLAMICP_PASS std::uint32_t half_squared_distance(CellPlace place, std::int32_t x, std::int32_t y) {
  const auto dx = static_cast<std::uint32_t>(place.x - x);
  const auto dy = static_cast<std::uint32_t>(place.y - y);
  return (dx * dx >> 1U) + (dy * dy >> 1U);
}

SLAMICP_PASS std::int32_t x_of(std::uint32_t point) { return static_cast<std::int16_t>(point & 0xFFFFU); }
SLAMICP_PASS std::int32_t y_of(std::uint32_t point) { return static_cast<std::int16_t>(point >> 16U); }

SLAMICP_PASS std::uint32_t places_below(const CellPlace* places, std::uint32_t point, std::uint32_t bound) {
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < places_at_once; ++k)
    bits |= (half_squared_distance(places[k], x_of(point), y_of(point)) < bound / 2 ? 1U : 0U) << k;
  return bits;
}

#endif

/// The nearest of `count` candidates. It may look at whole groups of places, the last of which goes on behind the list:
/// those are map points too.
SLAMICP_PASS Found find_nearest(const CellPlace* places, std::uint32_t count, std::uint32_t point) {
#if HWY_TARGET == HWY_SCALAR
  const std::int32_t x = x_of(point);
  const std::int32_t y = y_of(point);
  std::uint64_t best = std::uint64_t{far / 2} << 32U;  // distance, then number: one comparison without a branch
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint64_t now = (std::uint64_t{half_squared_distance(places[k], x, y)} << 32U) | k;
    best = now < best ? now : best;
  }
  return {static_cast<std::uint32_t>(best >> 32U) * 2, static_cast<std::uint32_t>(best)};
#else
  const std::uint32_t first = nearest_of_first(places, point);
  Found best{first, first & which_bits};
  for (std::uint32_t k = places_at_once; HWY_UNLIKELY(k < count); k += places_at_once) {
    const std::uint32_t now = nearest_of_first(places + k, point);
    if ((now & ~which_bits) < (best.squared & ~which_bits)) best = {now, k + (now & which_bits)};
  }
  return best;
#endif
}

SLAMICP_PASS std::uint32_t first_of(std::uint32_t word) { return (word >> 6U) & 0x3FFFU; }
SLAMICP_PASS const CellPlace* places_of(const CellTable* table) {
  return reinterpret_cast<const CellPlace*>(table + 1);
}

SLAMICP_PASS const CellLine* line_of(const CellTable* table, std::uint32_t candidate) {
  return reinterpret_cast<const CellLine*>(table) - 1 - candidate;
}

/// Nothing is near the lanes behind the block's last point.
SLAMICP_PASS void close_block(Block& block) {
  for (std::uint32_t i = block.count; i % lanes != 0; ++i) block.squared[i] = far;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
