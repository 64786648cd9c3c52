// SPDX-License-Identifier: Apache-2.0
#include "io/picture_view.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp::drawing {
namespace {

constexpr double smallest_height_px = 160.0;

/// Points farther out than any robot goes would make numbers that no picture can hold.
bool is_drawable(const Point2& point) noexcept { return is_finite<2>(point) && point.cwiseAbs().maxCoeff() < 1e9; }

struct Including {
  Bounds<2>& bounds;

  void one(const Point2& point) const {
    if (is_drawable(point)) bounds.include(point);
  }
  void around(const Point2& centre, double radius) const {
    const double reach = std::isfinite(radius) ? std::abs(radius) : 0.0;
    one(centre - Point2(reach, reach));
    one(centre + Point2(reach, reach));
  }
  void operator()(const Picture::Dots& dots) const {
    for (const Point2& point : dots.at) one(point);
  }
  void operator()(const Picture::Lines& lines) const {
    for (const auto& line : lines.lines)
      for (const Point2& point : line) one(point);
  }
  void operator()(const Picture::Circle& circle) const { around(circle.centre, circle.radius); }
  void operator()(const Picture::Robot& robot) const { around(robot.pose.translation(), robot.radius); }
  void operator()(const Picture::Label& label) const { one(label.at); }
};

Bounds<2> bounds_of_layers(const Picture& picture) {
  Bounds<2> bounds;
  for (const Picture::Layer& layer : picture.layers()) std::visit(Including{bounds}, layer.shape);
  if (bounds.empty()) return {{0.0, 0.0}, {1.0, 1.0}};
  const double extent = (bounds.upper - bounds.lower).maxCoeff();
  const double margin = extent > 0.0 ? 0.03 * extent : 0.5;
  return {bounds.lower.array() - margin, bounds.upper.array() + margin};
}

void widen(Bounds<2>& bounds, int axis, double extent) {
  const double more = 0.5 * (extent - (bounds.upper[axis] - bounds.lower[axis]));
  if (more <= 0.0) return;
  bounds.lower[axis] -= more;
  bounds.upper[axis] += more;
}

}  // namespace

View view_of(const Picture& picture, double left, double top, double width) {
  View view;
  view.world = picture.options().bounds ? *picture.options().bounds : bounds_of_layers(picture);
  const Point2 extent = view.world.upper - view.world.lower;
  view.scale = std::min(width / extent.x(), picture.options().largest_height_px / extent.y());
  const double height = std::max(extent.y() * view.scale, smallest_height_px);
  widen(view.world, 0, width / view.scale);
  widen(view.world, 1, height / view.scale);
  view.plot = {left, top, width, height};
  return view;
}

double round_step(double at_least) noexcept {
  const double power = std::pow(10.0, std::floor(std::log10(at_least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= at_least * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

}  // namespace slamicp::drawing
