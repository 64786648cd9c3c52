// SPDX-License-Identifier: Apache-2.0
#include "search/surface_fit.hpp"

#include <slamicp/error.hpp>

namespace slamicp {

void check(const SurfaceOptions& options) {
  const auto refuse = [](const char* what, const char* mend) { throw Error(what, "SurfaceOptions", mend); };
  if (options.neighbours < 0 || options.neighbours > static_cast<int>(max_surface_neighbours))
    refuse("neighbours is out of range", "give 0 (no surfaces) to 64; 12 is the default");
  if (!(options.radius > 0.0)) refuse("radius is not above zero", "give metres; 0.5 is the default");
  if (options.min_neighbours < 3) refuse("min_neighbours is below 3", "two points make no surface; 5 is the default");
  if (options.neighbours > 0 && options.min_neighbours > options.neighbours)
    refuse("min_neighbours is above neighbours", "no point could have a surface: lower it, or give 0 neighbours");
  if (!(options.scatter > 0.0)) refuse("scatter is not above zero", "give a share of variances; 1.3 is the default");
  if (options.threads < 1) refuse("threads is below 1", "give the number of threads to use");
}

}  // namespace slamicp
