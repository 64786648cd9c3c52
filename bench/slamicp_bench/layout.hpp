// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp::bench {

enum class LayoutKind {
  corridor,  ///< 2.5 m wide, with door niches, pilasters and alcoves
  office,    ///< a grid of furnished rooms with open doors
  hall,      ///< pillars and racks in a wide room
};

const char* to_string(LayoutKind kind);

/// A building, nothing in it repeating, and the part of it where a robot may be.
struct Layout {
  World world;
  Bounds<2> interior;
};

/// A building with so many metres of wall. Throws std::invalid_argument below 1 m.
Layout make_layout(LayoutKind kind, double wall_length, Random& random);

}  // namespace slamicp::bench
