// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/drawing.hpp"

namespace slamicp::drawing {

/// From metres to pixels: which part of the world the plot shows, at which scale.
struct View {
  Bounds<2> world;     ///< [m]
  Rectangle plot;      ///< [px]
  double scale = 1.0;  ///< [px/m]

  Pixel operator()(const Point2& point) const noexcept {
    return {plot.left + (point.x() - world.lower.x()) * scale, plot.bottom() - (point.y() - world.lower.y()) * scale};
  }
};

/// The view of all that the picture holds, or of the bounds that it asks for, widened where a plot would get too
/// narrow or too flat to read.
View view_of(const Picture& picture, double left, double top, double width);

/// The smallest of 1, 2, 5 times a power of ten that is at least so large.
double round_step(double at_least) noexcept;

}  // namespace slamicp::drawing
