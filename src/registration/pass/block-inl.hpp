// SPDX-License-Identifier: Apache-2.0
// A scan in blocks that stay in the first cache, and where their points lie in the map.
#pragma once

#include "registration/pass/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

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

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
