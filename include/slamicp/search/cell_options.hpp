// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slamicp {

/// How a plane map is cut into the cells of its index (CellIndex).
struct CellOptions {
  /// Side of a cell [m]. Smaller cells have shorter lists and take more memory; larger than the spacing of the
  /// map's points several times over, lists grow long. Rounded to a multiple of 1/65536 m. Range 0.005 to 0.25.
  double cell = 0.05;
  /// Cells answer queries within this [m]: make it the larger of max_correspondence_distance and outlier_distance. A
  /// query beyond is answered too, more slowly. Memory grows with it. At most 15 cells.
  double reach = 0.3;
  /// Build every cell at once. False: the map can be used at once, slowly, and IndexedPoints::build() makes it fast.
  bool eager = true;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

}  // namespace slamicp
