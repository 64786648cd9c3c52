// SPDX-License-Identifier: Apache-2.0
// The sums of a point-to-point step.
#pragma once

#include "registration/pass/pairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

SLAMICP_PASS void point_pass(const Request& request, PointSums* sums) noexcept {
  const D d;
  const V origin_x = hn::Set(d, request.place.x);
  const V origin_y = hn::Set(d, request.place.y);
  V w = hn::Zero(d), sx = w, sy = w, tx = w, ty = w, xx = w, xy = w, yx = w, yy = w, ranges = w;
  std::size_t pairs = 0;
  const std::uint32_t undecided = for_each_vector<true>(request, [&](const Block& block, std::uint32_t k, M hit) {
    const V map_x = hn::Load(d, block.map_x + k);
    const V map_y = hn::Load(d, block.map_y + k);
    const V dx = hn::Sub(map_x, hn::Add(hn::Load(d, block.rx + k), origin_x));
    const V dy = hn::Sub(map_y, hn::Add(hn::Load(d, block.ry + k), origin_y));
    const V distance = hn::Sqrt(hn::IfThenElseZero(hit, hn::MulAdd(dx, dx, hn::Mul(dy, dy))));
    const V weight = hn::IfThenElseZero(hit, kernel_weights(request.kernel, request.kernel_scale, distance));
    const M used = hn::Gt(weight, hn::Zero(d));
    // Where there is no pair, coordinates may be large, and infinity times nothing is not nothing.
    const V mx = hn::IfThenElseZero(used, map_x);
    const V my = hn::IfThenElseZero(used, map_y);
    const V px = hn::IfThenElseZero(used, hn::Load(d, block.px + k));
    const V py = hn::IfThenElseZero(used, hn::Load(d, block.py + k));
    const V wpx = hn::Mul(weight, px);
    const V wpy = hn::Mul(weight, py);
    w = hn::Add(w, weight);
    sx = hn::Add(sx, wpx);
    sy = hn::Add(sy, wpy);
    tx = hn::MulAdd(weight, mx, tx);
    ty = hn::MulAdd(weight, my, ty);
    xx = hn::MulAdd(mx, wpx, xx);
    xy = hn::MulAdd(mx, wpy, xy);
    yx = hn::MulAdd(my, wpx, yx);
    yy = hn::MulAdd(my, wpy, yy);
    ranges = hn::Add(ranges, hn::MulAdd(px, px, hn::Mul(py, py)));
    pairs += hn::CountTrue(d, used);
  });
  *sums = {sum(w),
           sum(sx),
           sum(sy),
           sum(tx),
           sum(ty),
           sum(xx),
           sum(xy),
           sum(yx),
           sum(yy),
           sum(ranges),
           static_cast<std::uint32_t>(pairs),
           undecided};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
