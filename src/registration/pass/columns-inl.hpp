// SPDX-License-Identifier: Apache-2.0
// A scan as the passes read it.
#pragma once

#include "registration/pass/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

SLAMICP_PASS std::uint32_t to_columns(const double* xy, std::uint32_t count, float* x, float* y, float* farthest,
                                      std::uint32_t* far_ones) noexcept {
  const D d;
  const V too_large = hn::Set(d, 1e4F);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = static_cast<float>(xy[2 * i]);
    y[i] = static_cast<float>(xy[2 * i + 1]);
  }
  for (std::uint32_t i = count; i < count + padding; ++i) x[i] = y[i] = absent;
  V most = hn::Zero(d);
  std::uint32_t usable = 0;
  for (std::uint32_t k = 0; k < count; k += lanes) {
    const V px = hn::LoadU(d, x + k);
    const V py = hn::LoadU(d, y + k);
    const V size = hn::Max(hn::Abs(px), hn::Abs(py));
    const M good = hn::And(hn::And(hn::Eq(px, px), hn::Eq(py, py)), hn::Lt(size, too_large));
    hn::StoreU(hn::IfThenElse(good, px, hn::Set(d, absent)), d, x + k);
    hn::StoreU(hn::IfThenElseZero(good, py), d, y + k);
    most = hn::Max(most, hn::IfThenElseZero(good, size));
    usable += static_cast<std::uint32_t>(hn::CountTrue(d, good));
  }
  *farthest = hn::GetLane(hn::MaxOfLanes(d, most));
  *far_ones = 0;
  if (HWY_LIKELY(usable == count)) return count;
  for (std::size_t i = 0; i < count; ++i) {
    const double nothing = (xy[2 * i] - xy[2 * i]) + (xy[2 * i + 1] - xy[2 * i + 1]);
    if (x[i] != absent || !(nothing == 0.0)) continue;
    x[i] = far_away;  // a number, but too large for a float
    ++*far_ones;
  }
  return usable + *far_ones;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
