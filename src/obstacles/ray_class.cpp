// SPDX-License-Identifier: Apache-2.0
#include <slamicp/obstacles/ray_class.hpp>

namespace slamicp {

const char* to_string(RayClass ray_class) noexcept {
  switch (ray_class) {
    case RayClass::obstacle:
      return "obstacle";
    case RayClass::gone:
      return "gone";
    case RayClass::unmapped:
      return "unmapped";
    case RayClass::unknown:
      return "unknown";
  }
  return "?";
}

}  // namespace slamicp
