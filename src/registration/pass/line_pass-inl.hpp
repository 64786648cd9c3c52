// SPDX-License-Identifier: Apache-2.0
// The sums of a point-to-line step, and of what its covariance needs.
#pragma once

#include "registration/pass/pairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

/// One vector's pairs: derivatives, residuals, weights; all zero where there is none.
struct Pairs {
  V nx, ny, turn, residual, weight;
  V rx, ry;
  M used;
};

/// Lane by lane a symmetric matrix of the unknowns.
struct SquareLanes {
  V xx, xy, yy, xt, yt, tt;

  // Written out, else GCC makes one that is not for this instruction set.
  HWY_INLINE SquareLanes() : xx(hn::Zero(D())), xy(xx), yy(xx), xt(xx), yt(xx), tt(xx) {}
  HWY_INLINE void add(V weight, const Pairs& pairs) {
    const V x = hn::Mul(weight, pairs.nx);
    const V y = hn::Mul(weight, pairs.ny);
    xx = hn::MulAdd(x, pairs.nx, xx);
    xy = hn::MulAdd(x, pairs.ny, xy);
    yy = hn::MulAdd(y, pairs.ny, yy);
    xt = hn::MulAdd(x, pairs.turn, xt);
    yt = hn::MulAdd(y, pairs.turn, yt);
    tt = hn::MulAdd(hn::Mul(weight, pairs.turn), pairs.turn, tt);
  }
  HWY_INLINE Square total() const { return {sum(xx), sum(xy), sum(yy), sum(xt), sum(yt), sum(tt)}; }
};

/// The sums of neighbouring pairs' pulls, group by group of 16 points, with what a group has in common with the next.
class Pulls {
 public:
  HWY_INLINE void add(const Pairs& pairs) {
    const V pull = hn::Mul(pairs.weight, pairs.residual);
    x_ += sum(hn::Mul(pull, pairs.nx));
    y_ += sum(hn::Mul(pull, pairs.ny));
    t_ += sum(hn::Mul(pull, pairs.turn));
    if (++vectors_ < group / lanes) return;
    close();
  }
  HWY_INLINE Square total() {
    close();
    return square_;
  }

 private:
  static constexpr std::uint32_t group = 16;

  HWY_INLINE void close() {
    // s s^T + (s l^T + l s^T) / 2, l the group before: with m = s + l, (s m^T + m s^T) / 2.
    const double mx = x_ + last_x_, my = y_ + last_y_, mt = t_ + last_t_;
    square_.xx += x_ * mx;
    square_.xy += 0.5 * (x_ * my + y_ * mx);
    square_.yy += y_ * my;
    square_.xt += 0.5 * (x_ * mt + t_ * mx);
    square_.yt += 0.5 * (y_ * mt + t_ * my);
    square_.tt += t_ * mt;
    last_x_ = x_;
    last_y_ = y_;
    last_t_ = t_;
    x_ = y_ = t_ = 0.0;
    vectors_ = 0;
  }

  double x_ = 0.0, y_ = 0.0, t_ = 0.0;
  double last_x_ = 0.0, last_y_ = 0.0, last_t_ = 0.0;
  std::uint32_t vectors_ = 0;
  Square square_{};
};

/// Sums what the covariance needs.
class NoiseLanes {
 public:
  HWY_INLINE explicit NoiseLanes(const Request& request)
      : ray_x_(hn::Set(D(), request.ray_x)),
        ray_y_(hn::Set(D(), request.ray_y)),
        sharing_(hn::Set(D(), request.sharing)) {}

  HWY_INLINE void add(const Pairs& pairs) {
    const D d;
    const V one = hn::Set(d, 1.0F);
    const V x = hn::Sub(pairs.rx, ray_x_);
    const V y = hn::Sub(pairs.ry, ray_y_);
    const V range2 = hn::Max(hn::MulAdd(x, x, hn::Mul(y, y)), hn::Set(d, 1e-6F));
    const V off_wall = hn::MulAdd(pairs.nx, x, hn::Mul(pairs.ny, y));
    const V per_range2 = hn::Div(one, range2);
    const V cosine2 = hn::Mul(hn::Mul(off_wall, off_wall), per_range2);
    const V shared = hn::Max(one, hn::Mul(sharing_, hn::Mul(hn::Abs(off_wall), per_range2)));
    const V weight2 = hn::Mul(pairs.weight, pairs.weight);
    by_range_.add(hn::Mul(weight2, cosine2), pairs);
    by_map_.add(hn::Mul(weight2, shared), pairs);
    pulls_.add(pairs);
    // Normals are as long as their lines are trusted.
    const V counted = hn::Mul(pairs.weight, hn::MulAdd(pairs.nx, pairs.nx, hn::Mul(pairs.ny, pairs.ny)));
    weights_ = hn::Add(weights_, counted);
    // Behind the last point and where there is no pair the coordinates are anything.
    const V rx = hn::IfThenElseZero(pairs.used, pairs.rx);
    const V ry = hn::IfThenElseZero(pairs.used, pairs.ry);
    const V wx = hn::Mul(counted, rx);
    const V wy = hn::Mul(counted, ry);
    x_ = hn::Add(x_, wx);
    y_ = hn::Add(y_, wy);
    ranges_ = hn::MulAdd(wx, rx, hn::MulAdd(wy, ry, ranges_));
    residuals_ = hn::MulAdd(hn::Mul(pairs.weight, pairs.residual), pairs.residual, residuals_);
    cosines_ = hn::MulAdd(pairs.weight, cosine2, cosines_);
    shared_ = hn::Add(shared_, hn::IfThenElseZero(pairs.used, hn::Mul(hn::Mul(counted, counted), shared)));
  }
  HWY_INLINE LineNoiseSums total() {
    return {by_range_.total(), by_map_.total(), pulls_.total(),  sum(weights_), sum(x_),
            sum(y_),           sum(ranges_),    sum(residuals_), sum(cosines_), sum(shared_)};
  }

 private:
  V ray_x_, ray_y_, sharing_;
  SquareLanes by_range_, by_map_;
  Pulls pulls_;
  V weights_ = hn::Zero(D()), x_ = weights_, y_ = weights_, ranges_ = weights_, residuals_ = weights_,
    cosines_ = weights_, shared_ = weights_;
};

template <bool weighted, bool noisy>
SLAMICP_PASS void line_pass_as(const Request& request, LineSums* sums) {
  const D d;
  const DI di;
  const DU du;
  const V unit = hn::Set(d, 1.0F / line_scale);
  V xx = hn::Zero(d), xy = xx, yy = xx, xt = xx, yt = xx, tt = xx, gx = xx, gy = xx, gt = xx, ranges = xx;
  std::size_t pairs = 0;
  NoiseLanes noise(request);
  const std::uint32_t undecided = for_each_vector<false>(request, [&](const Block& block, std::uint32_t k, M hit) {
    VU packed, offset;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(block.line + k), packed, offset);
    const VI normal = hn::IfThenElseZero(hn::RebindMask(di, hit), hn::BitCast(di, packed));
    const V nx = hn::Mul(unit, hn::ConvertTo(d, hn::ShiftRight<16>(hn::ShiftLeft<16>(normal))));
    const V ny = hn::Mul(unit, hn::ConvertTo(d, hn::ShiftRight<16>(normal)));
    const V x = hn::Load(d, block.x + k);
    const V y = hn::Load(d, block.y + k);
    const V rx = hn::Load(d, block.rx + k);
    const V ry = hn::Load(d, block.ry + k);
    const M used_lines = hn::RebindMask(d, hn::Ne(normal, hn::Zero(di)));
    const V line_offset = hn::IfThenElseZero(used_lines, hn::BitCast(d, offset));
    const V residual = hn::NegMulAdd(nx, x, hn::NegMulAdd(ny, y, line_offset));
    const V turn = hn::Sub(hn::Mul(ny, rx), hn::Mul(nx, ry));
    M used = used_lines;
    V wx = nx, wy = ny, wt = turn;
    V weight = hn::Set(d, 1.0F);
    if constexpr (weighted) {
      weight = kernel_weights(request.kernel, request.kernel_scale, residual);
      wx = hn::Mul(wx, weight);
      wy = hn::Mul(wy, weight);
      wt = hn::Mul(wt, weight);
      used = hn::And(used, hn::Gt(weight, hn::Zero(d)));
    }
    xx = hn::MulAdd(wx, nx, xx);
    xy = hn::MulAdd(wx, ny, xy);
    yy = hn::MulAdd(wy, ny, yy);
    xt = hn::MulAdd(wx, turn, xt);
    yt = hn::MulAdd(wy, turn, yt);
    tt = hn::MulAdd(wt, turn, tt);
    gx = hn::MulAdd(wx, residual, gx);
    gy = hn::MulAdd(wy, residual, gy);
    gt = hn::MulAdd(wt, residual, gt);
    ranges = hn::Add(ranges, hn::IfThenElseZero(used, hn::MulAdd(rx, rx, hn::Mul(ry, ry))));
    pairs += hn::CountTrue(d, used);
    if constexpr (noisy)
      noise.add({nx, ny, turn, hn::IfThenElseZero(used, residual), hn::IfThenElseZero(used, weight), rx, ry, used});
  });
  *sums = {sum(xx),
           sum(xy),
           sum(yy),
           sum(xt),
           sum(yt),
           sum(tt),
           sum(gx),
           sum(gy),
           sum(gt),
           sum(ranges),
           static_cast<std::uint32_t>(pairs),
           undecided,
           {}};
  if constexpr (noisy) sums->noise = noise.total();
}

SLAMICP_PASS void line_pass(const Request& request, LineSums* sums) noexcept {
  const bool weighted = request.kernel != RobustKernel::none;
  if (request.noise)
    weighted ? line_pass_as<true, true>(request, sums) : line_pass_as<false, true>(request, sums);
  else
    weighted ? line_pass_as<true, false>(request, sums) : line_pass_as<false, false>(request, sums);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
