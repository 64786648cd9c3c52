// SPDX-License-Identifier: Apache-2.0
// Goes through a scan pair by pair, for the passes that sum.
#pragma once

#include "registration/pass/nearest-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

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

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
HWY_AFTER_NAMESPACE();
