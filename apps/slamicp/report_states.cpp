// SPDX-License-Identifier: Apache-2.0
#include "report_states.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <slamicp/io/chart.hpp>

#include "output.hpp"

namespace slamicp::command {
namespace {

constexpr std::array<TrackingState, 4> all_states = {TrackingState::tracking, TrackingState::degenerate,
                                                     TrackingState::suspect, TrackingState::lost};

/// Told apart from each other, and from the colours of points.
constexpr Colour colour_of(TrackingState state) noexcept {
  switch (state) {
    case TrackingState::degenerate:
      return {240, 145, 30};
    case TrackingState::suspect:
      return {148, 62, 165};
    case TrackingState::lost:
      return {20, 20, 24};
    case TrackingState::tracking:
      break;
  }
  return colours::path;
}

std::size_t scans_in(const RunRecord& record, TrackingState state) {
  const auto found = record.states.find(state);
  return found == record.states.end() ? 0 : found->second;
}

// ---- the path -------------------------------------------------------------------------------------------------------

void draw_path(Picture& picture, const RunRecord& record) {
  for (const TrackingState state : all_states) {
    std::vector<Picture::Segment> pieces;
    for (std::size_t k = 0; k < record.scans.size(); ++k)
      if (record.scans[k].state == state)
        pieces.push_back(
            {record.trajectory[k > 0 ? k - 1 : 0].pose.translation(), record.trajectory[k].pose.translation()});
    if (pieces.empty()) continue;
    const double width = state == TrackingState::tracking ? 1.3 : 3.0;
    picture.segments(pieces, colour_of(state), width,
                     std::string("path, ") + to_string(state) + format(" (%zu)", pieces.size()));
  }
}

double largest_side(const Bounds<2>& bounds) noexcept { return (bounds.upper - bounds.lower).maxCoeff(); }

Bounds<2> bounds_of_path(const RunRecord& record) {
  constexpr double margin = 2.0;  // [m]
  Bounds<2> bounds;
  for (const StampedPose& stamped : record.trajectory) bounds.include(stamped.pose.translation());
  return {bounds.lower.array() - margin, bounds.upper.array() + margin};
}

/// Longer half axis of the 95 % ellipse [m].
double reach_of(const Matrix<3, 3>& covariance) noexcept {
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(5.991465 * (mean + std::hypot(half, covariance(0, 1))));
}

/// 1, 2, 5, 10, ... that makes the median ellipse a fiftieth of the picture.
double magnification_of(const RunRecord& record, double extent) {
  std::vector<double> reaches;
  for (const ScanRecord& scan : record.scans)
    if (const double reach = reach_of(scan.covariance); !is_doubted(scan.state) && reach > 0.0)
      reaches.push_back(reach);
  if (reaches.empty()) return 1.0;
  const auto middle = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
  std::nth_element(reaches.begin(), middle, reaches.end());
  const double wanted = std::clamp(0.02 * extent / *middle, 1.0, 1000.0);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double digit : {5.0, 2.0})
    if (wanted >= digit * power) return digit * power;
  return power;
}

void draw_ellipses(Picture& picture, const RunRecord& record, double extent) {
  struct Drawn {
    Point2 centre;
    double reach;
  };
  const double magnified = magnification_of(record, extent);
  std::vector<Drawn> drawn;
  std::vector<Picture::Ellipse> ellipses;
  for (std::size_t k = 0; k < record.scans.size(); ++k) {
    const ScanRecord& scan = record.scans[k];
    const double reach = magnified * reach_of(scan.covariance);
    // Of a doubted pose the ellipse says nothing, and one as large as the picture shows nothing.
    if (is_doubted(scan.state) || !(reach > 0.0) || reach > 0.25 * extent) continue;
    const Point2 centre = record.trajectory[k].pose.translation();
    if (std::any_of(drawn.begin(), drawn.end(), [&](const Drawn& other) {
          return (other.centre - centre).norm() < other.reach + reach + 0.005 * extent;
        }))
      continue;
    drawn.push_back({centre, reach});
    ellipses.push_back({centre, scan.covariance.topLeftCorner<2, 2>()});
  }
  if (!ellipses.empty())
    picture.ellipses(ellipses, magnified, colours::ellipse, 1.3, format("95 %% ellipses, x %.0f", magnified));
}

void draw_blind_directions(Picture& picture, const RunRecord& record, double extent) {
  const double half_length = 0.01 * extent;
  std::vector<Picture::Segment> strokes;
  Point2 last(std::numeric_limits<double>::infinity(), 0.0);
  for (std::size_t k = 0; k < record.scans.size(); ++k) {
    const Vector<2>& direction = record.scans[k].blind_direction;
    const Point2 centre = record.trajectory[k].pose.translation();
    if (direction.isZero() || (centre - last).norm() < 2.5 * half_length) continue;
    last = centre;
    strokes.push_back({centre - half_length * direction, centre + half_length * direction});
  }
  if (!strokes.empty()) picture.segments(strokes, colours::blind, 2.6, "blind direction");
}

// ---- over time ------------------------------------------------------------------------------------------------------

/// One value a scan; of more scans than pixels each pixel shows the one that `worse` picks.
template <class Worse>
std::vector<Point2> curve_of(const std::vector<double>& times, const std::vector<double>& values, Worse worse) {
  constexpr std::size_t most = 800;
  const std::size_t count = values.size();
  const std::size_t columns = std::min(count, most);
  std::vector<Point2> curve;
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t first = count * column / columns;
    const std::size_t last = std::max(first + 1, count * (column + 1) / columns);
    std::size_t shown = first;
    for (std::size_t k = first; k < last; ++k)
      if (worse(values[k], values[shown])) shown = k;
    curve.emplace_back(times[shown], values[shown]);
  }
  return curve;
}

void add_bands(Chart& chart, const RunRecord& record, const std::vector<double>& times) {
  for (std::size_t k = 0; k < record.scans.size();) {
    const TrackingState state = record.scans[k].state;
    std::size_t end = k;
    while (end < record.scans.size() && record.scans[end].state == state) ++end;
    Colour colour = colour_of(state);
    colour.opacity = state == TrackingState::lost ? 0.35 : 0.25;
    if (state != TrackingState::tracking) chart.band(times[k], times[std::min(end, times.size() - 1)], colour);
    k = end;
  }
}

std::string inline_chart(const Chart& chart) {
  const std::string svg = chart.svg();
  return svg.substr(std::min(svg.find("<svg"), svg.size()));
}

std::vector<double> sigmas_of(const RunRecord& record, int axis) {
  std::vector<double> sigmas;
  sigmas.reserve(record.scans.size());
  for (const ScanRecord& scan : record.scans) sigmas.push_back(1e3 * std::sqrt(scan.covariance(axis, axis)));
  return sigmas;
}

}  // namespace

void draw_states(Picture& picture, const RunRecord& record) {
  const double extent = largest_side(bounds_of_path(record));
  draw_path(picture, record);
  draw_ellipses(picture, record, extent);
  draw_blind_directions(picture, record, extent);
}

std::optional<Bounds<2>> worth_a_closer_look(const RunRecord& record) {
  Bounds<2> map;
  for (const Point2& point : record.map->points())
    if (is_finite<2>(point)) map.include(point);
  const Bounds<2> path = bounds_of_path(record);
  if (map.empty() || largest_side(path) > 0.6 * largest_side(map)) return std::nullopt;
  return path;
}

std::string table_of_states(const RunRecord& record) {
  std::string table = "<table class=\"states\">\n<tr><th>state</th><th>scans</th><th>share</th><th>longest</th></tr>\n";
  const std::vector<double> times = record.times();
  for (const TrackingState state : all_states) {
    double longest = 0.0;
    for (std::size_t k = 0, begin = 0; k < record.scans.size(); ++k) {
      if (record.scans[k].state != state)
        begin = k + 1;
      else
        longest = std::max(longest, times[std::min(k + 1, times.size() - 1)] - times[begin]);
    }
    const std::size_t count = scans_in(record, state);
    table += format("<tr><td>%s</td><td>%zu</td><td>%.1f %%</td><td>%.1f %s</td></tr>\n", to_string(state), count,
                    100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, times.size())),
                    longest, record.has_times() ? "s" : "scans");
  }
  return table + "</table>\n";
}

std::string charts_of_states(const RunRecord& record) {
  const std::vector<double> times = record.times();
  const std::string x_label = record.has_times() ? "time [s]" : "scan";
  std::vector<double> probabilities;
  probabilities.reserve(record.scans.size());
  for (const ScanRecord& scan : record.scans) probabilities.push_back(scan.probability);

  Chart probability({.title = "probability that the pose is right",
                     .x_label = x_label,
                     .y_label = "probability",
                     .width_px = 860.0,
                     .height_px = 230.0});
  add_bands(probability, record, times);
  probability.line(curve_of(times, probabilities, std::less<>()), colours::map, 1.5);

  Chart deviations({.title = "standard deviations",
                    .x_label = x_label,
                    .y_label = "mm, mrad",
                    .logarithmic = true,
                    .width_px = 860.0,
                    .height_px = 250.0});
  add_bands(deviations, record, times);
  deviations.line(curve_of(times, sigmas_of(record, 0), std::greater<>()), colours::map, 1.3, "x [mm]")
      .line(curve_of(times, sigmas_of(record, 1), std::greater<>()), colours::inlier, 1.3, "y [mm]")
      .line(curve_of(times, sigmas_of(record, 2), std::greater<>()), colours::outlier, 1.3, "heading [mrad]");

  std::string key = "<p>Behind the curves: ";
  for (const TrackingState state : {TrackingState::degenerate, TrackingState::suspect, TrackingState::lost}) {
    const Colour colour = colour_of(state);
    key += format("<span style=\"background:rgba(%d,%d,%d,.35)\">&nbsp;&nbsp;&nbsp;&nbsp;</span> %s&ensp;", colour.red,
                  colour.green, colour.blue, to_string(state));
  }
  return inline_chart(probability) + inline_chart(deviations) + key + "</p>\n";
}

}  // namespace slamicp::command
