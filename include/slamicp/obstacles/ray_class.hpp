// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slamicp {

/// What a ray that fits nothing in the map says about the map. It does not say what a robot may drive through: whatever
/// a ray ends on stands there.
enum class RayClass : unsigned char {
  obstacle,  ///< ends in front of a mapped surface: something stands there that the map does not know
  gone,      ///< went through a mapped surface: it was taken away, a door stands open, or it is glass
  unmapped,  ///< ends where the map has nothing, neither before nor behind: beyond the edge of what was mapped
  unknown,   ///< cannot be told: the ray grazes a mapped surface, or meets one without a direction
};

/// "obstacle", "gone", "unmapped", "unknown"
const char* to_string(RayClass ray_class) noexcept;

}  // namespace slamicp
