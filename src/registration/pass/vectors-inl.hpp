// SPDX-License-Identifier: Apache-2.0
// What the passes compute with: a vector of floats, as wide as the instruction set has it.
#pragma once

#include <hwy/highway.h>

#include "registration/pass/pass.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using M = hn::Mask<D>;

#define SLAMICP_PASS static HWY_INLINE HWY_MAYBE_UNUSED

constexpr std::uint32_t lanes = static_cast<std::uint32_t>(hn::MaxLanes(D()));

/// The largest whole number not above v, which a float can be cut to.
SLAMICP_PASS VI floor(V v) {
  const D d;
  const DI di;
#if HWY_TARGET == HWY_SCALAR
  const VI cut = hn::Set(di, static_cast<std::int32_t>(hn::GetLane(v)));  // ConvertTo minds what cannot be here
#else
  const VI cut = hn::ConvertTo(di, v);
#endif
  const M above = hn::Gt(hn::ConvertTo(d, cut), v);
  return hn::Add(cut, hn::BitCast(di, hn::VecFromMask(d, above)));  // all bits set: minus one
}

SLAMICP_PASS VI rounded(V v) {
#if HWY_TARGET == HWY_SCALAR
  return floor(hn::Add(v, hn::Set(D(), 0.5F)));
#else
  return hn::NearestInt(v);
#endif
}

/// Of all lanes.
SLAMICP_PASS double sum(V v) { return static_cast<double>(hn::GetLane(hn::SumOfLanes(D(), v))); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
