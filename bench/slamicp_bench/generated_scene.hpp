// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "layout.hpp"
#include "scene.hpp"

namespace slamicp::bench {

/// A scene to make up. The map's points are as dense as in the corridor of the data, so more of them are a larger
/// building.
struct Recipe {
  LayoutKind layout = LayoutKind::office;
  double map_points = 2e4;
  int beams = 1081;            ///< over 270 deg
  double outlier_share = 0.1;  ///< of the returns, from things that the map does not know
  double guess_sigma = 0.05;   ///< along x and y [m], cut at 2.5 sigma
  double guess_turn_sigma_deg = 2.0;
  std::size_t scans = 40;
  std::uint64_t seed = 1;
};

/// Scans in runs of five, a step of 5 cm apart, each run somewhere else. The same recipe gives the same scene.
Scene make_scene(const Recipe& recipe);

}  // namespace slamicp::bench
