// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/io/picture.hpp>

#include "io/drawing.hpp"

namespace slamicp {
namespace {

/// A closed line; none where it is no covariance.
std::vector<Point2> rim_of(const Picture::Ellipse& ellipse, double magnified) {
  constexpr int corners = 36;
  const double sigmas = std::sqrt(5.991465);  // 95 % of chi-squared with two degrees of freedom
  if (!ellipse.covariance.allFinite() || !is_finite<2>(ellipse.centre)) return {};
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(ellipse.covariance);
  if (!(eigen.eigenvalues()[0] >= 0.0)) return {};
  const Eigen::Matrix2d axes = magnified * sigmas * eigen.eigenvectors() * eigen.eigenvalues().cwiseSqrt().asDiagonal();
  std::vector<Point2> rim;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k % corners) / corners;
    rim.emplace_back(ellipse.centre + axes * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return rim;
}

}  // namespace

std::string PictureOptions::problem() const {
  if (!(width_px >= 300.0 && width_px <= 4000.0)) return "width_px is not in 300 .. 4000";
  if (!(largest_height_px >= 100.0 && largest_height_px <= 4000.0)) return "largest_height_px is not in 100 .. 4000";
  if (!(png_scale >= 0.5 && png_scale <= 8.0)) return "png_scale is not in 0.5 .. 8";
  if (!bounds) return {};
  if (!is_finite<2>(bounds->lower) || !is_finite<2>(bounds->upper)) return "bounds are not finite";
  if (!(bounds->lower.array() < bounds->upper.array()).all()) return "bounds hold nothing: lower is not below upper";
  return {};
}

Picture::Picture(PictureOptions options) : options_(std::move(options)) {
  if (const std::string problem = options_.problem(); !problem.empty()) throw Error(problem, "PictureOptions");
}

Picture& Picture::add(Layer layer) {
  layers_.push_back(std::move(layer));
  return *this;
}

Picture& Picture::points(std::span<const Point2> points, Colour colour, double radius_px, std::string legend) {
  return add({Dots{{points.begin(), points.end()}, radius_px}, colour, std::move(legend)});
}

Picture& Picture::polyline(std::span<const Point2> points, Colour colour, double width_px, std::string legend) {
  return add({Lines{{{points.begin(), points.end()}}, width_px}, colour, std::move(legend)});
}

Picture& Picture::path(std::span<const StampedPose> trajectory, Colour colour, double width_px, std::string legend) {
  std::vector<Point2> points;
  points.reserve(trajectory.size());
  for (const StampedPose& stamped : trajectory) points.push_back(stamped.pose.translation());
  return polyline(points, colour, width_px, std::move(legend));
}

Picture& Picture::segments(std::span<const Segment> segments, Colour colour, double width_px, std::string legend) {
  Lines lines{{}, width_px};
  lines.lines.reserve(segments.size());
  for (const Segment& segment : segments) lines.lines.push_back({segment.from, segment.to});
  return add({std::move(lines), colour, std::move(legend)});
}

Picture& Picture::circle(const Point2& centre, double radius, Colour colour, double width_px, std::string legend) {
  return add({Circle{centre, radius, width_px}, colour, std::move(legend)});
}

Picture& Picture::ellipses(std::span<const Ellipse> ellipses, double magnified, Colour colour, double width_px,
                           std::string legend) {
  Lines lines{{}, width_px};
  for (const Ellipse& ellipse : ellipses)
    if (std::vector<Point2> rim = rim_of(ellipse, magnified); !rim.empty()) lines.lines.push_back(std::move(rim));
  return add({std::move(lines), colour, std::move(legend)});
}

Picture& Picture::robot(const Pose2& pose, double radius, Colour colour, std::string legend) {
  return add({Robot{pose, radius}, colour, std::move(legend)});
}

Picture& Picture::label(const Point2& at, std::string text, Colour colour) {
  return add({Label{at, std::move(text)}, colour, {}});
}

std::string Picture::svg() const { return drawing::to_svg(drawing::lay_out(*this)); }

void Picture::save(const std::filesystem::path& path) const {
  drawing::save(drawing::lay_out(*this), options_.png_scale, path);
}

}  // namespace slamicp
