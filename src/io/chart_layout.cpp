// SPDX-License-Identifier: Apache-2.0
#include "io/chart_layout.hpp"

#include <algorithm>
#include <cmath>

#include "io/picture_view.hpp"
#include "io/text.hpp"

namespace slamicp::drawing {
namespace {

constexpr Colour mark_line{120, 126, 136};

constexpr double left_margin = 62.0;
constexpr double right_margin = 18.0;
constexpr double bottom_margin = 46.0;
constexpr double row_height = 20.0;
constexpr double swatch = 22.0;
constexpr double small = 11.0;
constexpr double medium = 12.5;
constexpr double large = 16.0;

/// From values to pixels.
struct Axes {
  double x_from = 0.0, x_to = 1.0;
  double y_from = 0.0, y_to = 1.0;  // logarithms where y is by powers of ten
  bool logarithmic = false;
  Rectangle plot;

  bool shows(const Point2& point) const noexcept { return is_finite<2>(point) && (!logarithmic || point.y() > 0.0); }
  double x(double value) const noexcept { return plot.left + (value - x_from) / (x_to - x_from) * plot.width; }
  double y(double value) const noexcept {
    const double height = logarithmic ? std::log10(value) : value;
    return plot.bottom() - (height - y_from) / (y_to - y_from) * plot.height;
  }
  Pixel operator()(const Point2& point) const noexcept { return {x(point.x()), y(point.y())}; }
};

/// What the chart holds, y from 0 or a power of ten to a round number.
Axes axes_of(const Chart& chart) {
  const ChartOptions& options = chart.options();
  Axes axes;
  axes.logarithmic = options.logarithmic;
  double x_least = 1e300, x_most = -1e300, y_least = 1e300, y_most = -1e300;
  for (const Chart::Series& series : chart.series())
    for (const Point2& point : series.points) {
      if (!axes.shows(point)) continue;
      x_least = std::min(x_least, point.x());
      x_most = std::max(x_most, point.x());
      y_least = std::min(y_least, point.y());
      y_most = std::max(y_most, point.y());
    }
  if (x_least > x_most) return axes;
  axes.x_from = options.x_names.empty() ? std::min(0.0, x_least) : -0.5;
  axes.x_to = options.x_names.empty() ? x_most : static_cast<double>(options.x_names.size()) - 0.5;
  if (!(axes.x_to > axes.x_from)) axes.x_to = axes.x_from + 1.0;
  if (axes.logarithmic) {
    axes.y_from = std::floor(std::log10(y_least));
    axes.y_to = std::max(axes.y_from + 1.0, std::ceil(std::log10(y_most)));
  } else {
    axes.y_from = std::min(0.0, y_least);
    axes.y_to = std::max(1.05 * y_most, axes.y_from + 1e-9);
  }
  return axes;
}

struct Entry {
  const Chart::Series* series;
  Pixel at;  // left end of the swatch
};

std::vector<Entry> place_legend(const Chart& chart, double right, double top) {
  std::vector<Entry> entries;
  Pixel at{left_margin, top + 0.5 * row_height};
  for (const Chart::Series& series : chart.series()) {
    if (series.legend.empty()) continue;
    const double width = swatch + 6.0 + width_of(series.legend, medium) + 18.0;
    if (at.x > left_margin && at.x + width - 18.0 > right) at = {left_margin, at.y + row_height};
    entries.push_back({&series, at});
    at.x += width;
  }
  return entries;
}

void draw_legend(const std::vector<Entry>& entries, std::vector<Command>& commands) {
  for (const auto& [series, at] : entries) {
    if (series->is_line)
      commands.push_back({Strokes{{{{at.x + 1.0, at.y}, {at.x + swatch - 1.0, at.y}}}, std::max(1.5, series->size_px)},
                          series->colour});
    else
      commands.push_back({Dots{{{at.x + 0.5 * swatch, at.y}}, series->size_px}, series->colour});
    commands.push_back({Text{{at.x + swatch + 6.0, at.y + 0.36 * medium}, series->legend, medium}, ink});
  }
}

std::string number_text(double value, double step) {
  std::string text;
  text::append_fixed(text, value, std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9));
  return text;
}

void draw_x_ticks(const Axes& axes, const ChartOptions& options, Strokes& grid, std::vector<Command>& commands) {
  const auto tick = [&](double value, const std::string& name) {
    const double at = axes.x(value);
    if (options.x_names.empty()) grid.lines.push_back({{at, axes.plot.top}, {at, axes.plot.bottom()}});
    commands.push_back({Text{{at, axes.plot.bottom() + 15.0}, name, small, Anchor::middle}, faint_ink});
  };
  for (std::size_t k = 0; k < options.x_names.size(); ++k) tick(static_cast<double>(k), options.x_names[k]);
  if (!options.x_names.empty()) return;
  const double step = round_step((axes.x_to - axes.x_from) * 64.0 / axes.plot.width);
  for (double value = std::ceil(axes.x_from / step) * step; value <= axes.x_to + 1e-9 * step; value += step)
    tick(value, number_text(value, step));
}

void draw_y_ticks(const Axes& axes, Strokes& grid, std::vector<Command>& commands) {
  const auto tick = [&](double value, const std::string& name) {
    const double at = axes.y(value);
    grid.lines.push_back({{axes.plot.left, at}, {axes.plot.right(), at}});
    commands.push_back({Text{{axes.plot.left - 6.0, at + 4.0}, name, small, Anchor::end}, faint_ink});
  };
  if (axes.logarithmic) {
    for (double power = axes.y_from; power <= axes.y_to + 1e-9; ++power) {
      const double value = std::pow(10.0, power);
      tick(value, number_text(value, value));
    }
    return;
  }
  const double step = round_step((axes.y_to - axes.y_from) * 34.0 / axes.plot.height);
  for (double k = std::ceil(axes.y_from / step - 1e-9); k * step <= axes.y_to + 1e-9 * step; ++k)
    tick(k * step, number_text(k * step, step));
}

void draw_frame(const Axes& axes, const ChartOptions& options, std::vector<Command>& commands) {
  const Rectangle& plot = axes.plot;
  commands.push_back(
      {Strokes{{{{plot.left, plot.top}, {plot.left, plot.bottom()}, {plot.right(), plot.bottom()}}}, 1.0}, axis_line});
  const Pixel below{plot.left + 0.5 * plot.width, plot.bottom() + 34.0};
  commands.push_back({Text{below, options.x_label, small, Anchor::middle}, ink});
  commands.push_back(
      {Text{{14.0, plot.top + 0.5 * plot.height}, options.y_label, small, Anchor::middle, false, true}, ink});
}

void draw_series(const Axes& axes, const Chart::Series& series, std::vector<Command>& commands) {
  if (!series.is_line) {
    Dots dots{{}, series.size_px};
    for (const Point2& point : series.points)
      if (axes.shows(point)) dots.at.push_back(axes(point));
    commands.push_back({std::move(dots), series.colour, true});
    return;
  }
  Strokes strokes{{{}}, series.size_px};
  for (const Point2& point : series.points) {
    if (axes.shows(point))
      strokes.lines.back().push_back(axes(point));
    else if (!strokes.lines.back().empty())
      strokes.lines.emplace_back();
  }
  commands.push_back({std::move(strokes), series.colour, true});
}

void draw_bands(const Axes& axes, const Chart& chart, std::vector<Command>& commands) {
  for (const Chart::Band& band : chart.bands()) {
    if (!std::isfinite(band.from) || !std::isfinite(band.to)) continue;
    const double from = std::clamp(axes.x(band.from), axes.plot.left, axes.plot.right());
    const double to = std::clamp(axes.x(band.to), axes.plot.left, axes.plot.right());
    const double right = std::max(to, from + 2.0);  // a single scan is seen too
    const double bottom = axes.plot.bottom(), top = axes.plot.top;
    commands.push_back({Area{{{from, bottom}, {from, top}, {right, top}, {right, bottom}}}, band.colour, true});
  }
}

void draw_marks(const Axes& axes, const Chart& chart, std::vector<Command>& commands) {
  for (const Chart::Mark& mark : chart.marks()) {
    const double at = axes.x(mark.x);
    commands.push_back({Strokes{{{{at, axes.plot.top}, {at, axes.plot.bottom()}}}, 1.0}, mark_line});
    commands.push_back({Text{{at, axes.plot.top - 4.0}, mark.text, medium, Anchor::middle, true}, ink});
  }
}

}  // namespace

Drawing lay_out(const Chart& chart) {
  const ChartOptions& options = chart.options();
  Drawing drawing;
  drawing.width = options.width_px;
  drawing.height = options.height_px;
  const double right = drawing.width - right_margin;
  const bool titled = !options.title.empty();
  const double legend_top = titled ? 40.0 : 12.0;
  const std::vector<Entry> legend = place_legend(chart, right, legend_top);
  const double over_marks = chart.marks().empty() ? 0.0 : 16.0;
  const double top = (legend.empty() ? legend_top + 2.0 : legend.back().at.y + 0.5 * row_height + 6.0) + over_marks;
  Axes axes = axes_of(chart);
  axes.plot = {left_margin, top, right - left_margin, std::max(40.0, drawing.height - bottom_margin - top)};
  drawing.height = axes.plot.bottom() + bottom_margin;
  drawing.plot = axes.plot;

  draw_bands(axes, chart, drawing.commands);
  Strokes grid{{}, 1.0};
  draw_x_ticks(axes, options, grid, drawing.commands);
  draw_y_ticks(axes, grid, drawing.commands);
  drawing.commands.push_back({std::move(grid), grid_line});
  draw_marks(axes, chart, drawing.commands);
  for (const Chart::Series& series : chart.series()) draw_series(axes, series, drawing.commands);
  draw_frame(axes, options, drawing.commands);
  draw_legend(legend, drawing.commands);
  if (titled) {
    const double width = width_of(options.title, large) * 1.08;
    const double size = std::max(8.0, large * std::min(1.0, (right - left_margin) / width));
    drawing.commands.push_back({Text{{left_margin, 28.0}, options.title, size, Anchor::start, true}, ink});
  }
  return drawing;
}

}  // namespace slamicp::drawing
