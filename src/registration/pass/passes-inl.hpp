// SPDX-License-Identifier: Apache-2.0
// The passes over a scan, once for every instruction set that includes this. No function here has a name that another
// file could link to: what is compiled for a newer machine must not be run on an older one.
//
// A pass goes through the scan in blocks that stay in the first cache. In a block all points are placed in the map,
// several at a time; then each finds its nearest candidate, several candidates at a time; then all pairs are summed,
// several at a time.
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
constexpr std::uint32_t block_size = 64;

/// Up to 64 points at work.
struct Block {
  std::uint32_t begin, count;                            // which points of the sequence
  HWY_ALIGN float px[block_size], py[block_size];        // in the robot's frame
  HWY_ALIGN float rx[block_size], ry[block_size];        // turned into the map's axes
  HWY_ALIGN float x[block_size], y[block_size];          // from the corner of the point's tile
  HWY_ALIGN std::uint32_t place[block_size];             // the same as a CellPlace
  HWY_ALIGN std::uint32_t tile[block_size];              // into Window::tables
  HWY_ALIGN std::uint32_t cell[block_size];              // into CellTable::cells
  HWY_ALIGN std::uint32_t squared[block_size];           // distance to the nearest candidate, in units of places
  HWY_ALIGN std::uint64_t line[block_size];              // CellLine of that candidate
  HWY_ALIGN float map_x[block_size], map_y[block_size];  // that candidate, from the corner of the robot's tile
  std::uint64_t undecided;                               // a bit for each point that the tables cannot answer
};

/// One point out of every `stride`, the one in the middle.
struct Sequence {
  ScanColumns scan;
  std::uint32_t stride;

  HWY_INLINE std::uint32_t count() const { return (scan.count - stride / 2 + stride - 1) / stride; }
  HWY_INLINE std::uint32_t index(std::uint32_t k) const { return stride / 2 + k * stride; }
};

/// Loads points of the sequence; behind its end they are absent.
SLAMICP_PASS void load_block(const Sequence& sequence, std::uint32_t begin, Block& block) {
  const D d;
  block.begin = begin;
  const std::uint32_t left = sequence.count() - begin;
  block.count = left < block_size ? left : block_size;
  if (sequence.stride == 1) {
    for (std::uint32_t k = 0; k < block.count; k += lanes) {
      hn::Store(hn::LoadU(d, sequence.scan.x + begin + k), d, block.px + k);
      hn::Store(hn::LoadU(d, sequence.scan.y + begin + k), d, block.py + k);
    }
    return;
  }
  std::uint32_t k = 0;
  for (; k < block.count; ++k) {
    block.px[k] = sequence.scan.x[sequence.index(begin + k)];
    block.py[k] = sequence.scan.y[sequence.index(begin + k)];
  }
  for (; k % lanes != 0; ++k) block.px[k] = block.py[k] = absent;
}

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

/// Moves the block's points into the map and finds their cells.
SLAMICP_PASS void place_block(const Window& window, const Place& place, Block& block) {
  const D d;
  const DI di;
  const DU du;
  const V cosine = hn::Set(d, place.cosine);
  const V sine = hn::Set(d, place.sine);
  const V origin_x = hn::Set(d, place.x);
  const V origin_y = hn::Set(d, place.y);
  const V per_metre = hn::Set(d, window.cells_per_metre);
  const V side = hn::Set(d, window.tile);
  const V half = hn::Set(d, 0.5F * window.tile);
  const V units = hn::Set(d, window.units_per_metre);
  const V most = hn::Set(d, 1e6F);
  const V least = hn::Set(d, -1e6F);
  const VI fifteen = hn::Set(di, 15);
  const VI width = hn::Set(di, window.width);
  const VU limit = hn::BitCast(du, width);
  const VI column = hn::Set(di, window.column);
  const VI row = hn::Set(di, window.row);
  const VI outside = hn::Mul(width, width);
  for (std::uint32_t k = 0; k < block.count; k += lanes) {
    const V px = hn::Load(d, block.px + k);
    const V py = hn::Load(d, block.py + k);
    const V rx = hn::NegMulAdd(sine, py, hn::Mul(cosine, px));
    const V ry = hn::MulAdd(sine, px, hn::Mul(cosine, py));
    const V x = hn::Add(rx, origin_x);
    const V y = hn::Add(ry, origin_y);
    const VI u = floor(hn::Min(hn::Max(hn::Mul(x, per_metre), least), most));
    const VI v = floor(hn::Min(hn::Max(hn::Mul(y, per_metre), least), most));
    const VI tile_u = hn::ShiftRight<4>(u);
    const VI tile_v = hn::ShiftRight<4>(v);
    const V corner_x = hn::Mul(hn::ConvertTo(d, tile_u), side);
    const V corner_y = hn::Mul(hn::ConvertTo(d, tile_v), side);
    const VI at_u = hn::Add(tile_u, column);
    const VI at_v = hn::Add(tile_v, row);
    const auto inside = hn::And(hn::Lt(hn::BitCast(du, at_u), limit), hn::Lt(hn::BitCast(du, at_v), limit));
    const VI tile = hn::IfThenElse(hn::RebindMask(di, inside), hn::Add(hn::Mul(at_v, width), at_u), outside);
    const VI cell = hn::Or(hn::ShiftLeft<4>(hn::And(v, fifteen)), hn::And(u, fifteen));
    hn::Store(rx, d, block.rx + k);
    hn::Store(ry, d, block.ry + k);
    const V in_tile_x = hn::Sub(x, corner_x);
    const V in_tile_y = hn::Sub(y, corner_y);
    hn::Store(in_tile_x, d, block.x + k);
    hn::Store(in_tile_y, d, block.y + k);
    // What lies outside may be anywhere: it has no candidates, but must not come near the place that stands for none.
    const VI place_x = rounded(hn::Mul(units, hn::Min(hn::Max(hn::Sub(in_tile_x, half), hn::Neg(half)), half)));
    const VI place_y = rounded(hn::Mul(units, hn::Min(hn::Max(hn::Sub(in_tile_y, half), hn::Neg(half)), half)));
    const VU both =
        hn::Or(hn::And(hn::BitCast(du, place_x), hn::Set(du, 0xFFFFU)), hn::ShiftLeft<16>(hn::BitCast(du, place_y)));
    hn::Store(both, du, block.place + k);
    hn::Store(hn::BitCast(du, tile), du, block.tile + k);
    hn::Store(hn::BitCast(du, cell), du, block.cell + k);
  }
}

/// Calls use(block) for one block of points in the map after the other.
template <class Use>
SLAMICP_PASS void for_each_block(const Sequence& sequence, const Window& window, const Place& place, const Use& use) {
  Block block;
  const std::uint32_t count = sequence.count();
  for (std::uint32_t begin = 0; begin < count; begin += block_size) {
    load_block(sequence, begin, block);
    place_block(window, place, block);
    use(block);
  }
}

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

/// Finds the nearest candidate of every point of the block.
/// @tparam want_place  the candidate's place, else its line
template <bool want_place>
SLAMICP_PASS void search_block(const Request& request, Block& block) {
  block.undecided = 0;
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const CellTable* table = request.window.tables[block.tile[i]];
    const std::uint32_t word = table->cells[block.cell[i]];
    const std::uint32_t first = first_of(word);
    std::uint32_t count = word & 63U;
    if (HWY_UNLIKELY(count == CellTable::no_answer)) {
      block.undecided |= std::uint64_t{1} << i;
      count = 0;
    }
    Found found = find_nearest(places_of(table) + first, count, block.place[i]);
    if (HWY_UNLIKELY((block.undecided >> i) & 1U)) found.squared = far;
    block.squared[i] = found.squared & ~which_bits;
    if constexpr (want_place) {
      block.map_x[i] = block.map_y[i] = 0.0F;
      if (block.squared[i] > request.gate.beyond) continue;
      const double* point =
          request.map_points + 2 * static_cast<std::ptrdiff_t>(line_of(table, first + found.which)->number);
      block.map_x[i] = static_cast<float>(point[0] - request.corner_x);
      block.map_y[i] = static_cast<float>(point[1] - request.corner_y);
    } else {
      hwy::CopyBytes<8>(line_of(table, first + found.which), block.line + i);
    }
  }
  close_block(block);
}

/// Which points of the block have their pair within the gate, and which are to be decided in double.
struct Verdict {
  M hit;
  M open;
};

SLAMICP_PASS Verdict judge(const Request& request, const Block& block, std::uint32_t k) {
  const D d;
  const DU du;
  const VU squared = hn::Load(du, block.squared + k);
  const M hit = hn::RebindMask(d, hn::Lt(squared, hn::Set(du, request.gate.sure)));
  const M beyond = hn::RebindMask(d, hn::Lt(hn::Set(du, request.gate.beyond), squared));
  return {hit, hn::Not(hn::Or(hit, beyond))};
}

/// Notes the points that are to be decided in double.
SLAMICP_PASS std::uint32_t note_undecided(const Request& request, const Sequence& sequence, const Block& block,
                                          std::uint32_t noted) {
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const std::uint32_t squared = block.squared[i];
    const bool is_near = squared >= request.gate.sure && squared <= request.gate.beyond;
    const bool is_beyond = request.looks_farther && squared > request.gate.beyond;
    const bool is_open = ((block.undecided >> i) & 1U) != 0 || is_near || is_beyond;
    if (is_open && block.px[i] < absent) request.undecided[noted++] = sequence.index(block.begin + i);
  }
  return noted;
}

/// Goes through the scan: use(block, k, hit) for the points from k on, hit where their pair is within the gate. Returns
/// how many points are noted as undecided.
/// @tparam want_place  the pairs' places, else their lines
template <bool want_place, class Use>
SLAMICP_PASS std::uint32_t for_each_vector(const Request& request, const Use& use) {
  const D d;
  const Sequence sequence{request.scan, request.stride};
  std::uint32_t undecided = 0;
  for_each_block(sequence, request.window, request.place, [&](Block& block) {
    search_block<want_place>(request, block);
    M open = hn::FirstN(d, 0);
    for (std::uint32_t k = 0; k < block.count; k += lanes) {
      const Verdict verdict = judge(request, block, k);
      open = hn::Or(open, verdict.open);
      use(block, k, verdict.hit);
    }
    if (HWY_UNLIKELY(block.undecided != 0 || request.looks_farther || !hn::AllFalse(d, open)))
      undecided = note_undecided(request, sequence, block, undecided);
  });
  return undecided;
}

SLAMICP_PASS V kernel_weights(RobustKernel kernel, float scale, V residual) {
  const D d;
  const V one = hn::Set(d, 1.0F);
  const V ratio = hn::Mul(residual, hn::Set(d, 1.0F / scale));
  const V square = hn::Mul(ratio, ratio);
  switch (kernel) {
    case RobustKernel::none:
      return one;
    case RobustKernel::huber:
      return hn::IfThenElse(hn::Le(square, one), one, hn::Div(one, hn::Abs(ratio)));
    case RobustKernel::cauchy:
      return hn::Div(one, hn::Add(one, square));
    case RobustKernel::geman_mcclure: {
      const V half = hn::Add(one, square);
      return hn::Div(one, hn::Mul(half, half));
    }
    case RobustKernel::tukey: {
      const V left = hn::Max(hn::Sub(one, square), hn::Zero(d));
      return hn::Mul(left, left);
    }
  }
  return one;
}

SLAMICP_PASS double sum(V v) { return static_cast<double>(hn::GetLane(hn::SumOfLanes(D(), v))); }

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

constexpr Passes all_passes{to_columns, line_pass, point_pass, outlier_pass, match_pass};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
