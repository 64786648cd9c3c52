// SPDX-License-Identifier: Apache-2.0
#include <slamicp/search/cell_options.hpp>

namespace slamicp {

std::string CellOptions::problem() const {
  if (!(cell >= 0.005 && cell <= 0.25)) return "cell must lie between 0.005 and 0.25 m; 0.05 is the default";
  if (!(reach > 0.0 && reach <= 15.0 * cell))
    return "reach must be above 0 m and at most 15 cells; 0.3 is the default, larger ones need larger cells";
  return {};
}

}  // namespace slamicp
