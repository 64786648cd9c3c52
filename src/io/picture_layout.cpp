// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "io/picture_view.hpp"
#include "io/text.hpp"

namespace slamicp::drawing {
namespace {

constexpr double left_margin = 52.0;
constexpr double right_margin = 18.0;
constexpr double bottom_margin = 50.0;
constexpr double small = 11.0;   // size of the axes' text
constexpr double medium = 12.5;  // of the legend's
constexpr double large = 16.0;   // of the title

/// One dot a place: dots that would cover each other are left out, whatever their number.
std::vector<Pixel> thinned(const std::vector<Point2>& points, const View& view, double radius) {
  const double cell = std::clamp(0.5 * radius, 0.25, 2.0);
  const double border = radius + 1.0;
  std::unordered_set<std::uint64_t> taken;
  std::vector<Pixel> kept;
  for (const Point2& point : points) {
    const Pixel pixel = view(point);
    const bool in_view = pixel.x > view.plot.left - border && pixel.x < view.plot.right() + border &&
                         pixel.y > view.plot.top - border && pixel.y < view.plot.bottom() + border;
    if (!in_view) continue;  // so is a NaN
    const auto column = static_cast<std::uint32_t>((pixel.x + border) / cell);
    const auto row = static_cast<std::uint32_t>((pixel.y + border) / cell);
    if (taken.insert((std::uint64_t{row} << 32) | column).second) kept.push_back(pixel);
  }
  return kept;
}

/// Leaves out corners that are nearer to the last one than an eye sees; a NaN breaks the line.
void append_line(std::vector<std::vector<Pixel>>& lines, const std::vector<Point2>& points, const View& view) {
  constexpr double nearest = 0.3;
  std::vector<Pixel> line;
  const auto finish = [&] {
    if (line.size() > 1) lines.push_back(line);
    line.clear();
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite<2>(points[i]) || points[i].cwiseAbs().maxCoeff() > 1e9) {
      finish();
      continue;
    }
    const Pixel pixel = view(points[i]);
    const bool last = i + 1 == points.size();
    if (last || line.empty() || std::hypot(pixel.x - line.back().x, pixel.y - line.back().y) >= nearest)
      line.push_back(pixel);
  }
  finish();
}

/// Turns a layer in metres into commands in pixels.
struct Drawer {
  const View& view;
  Colour colour;
  std::vector<Command>& commands;

  template <class Shape>
  void add(Shape shape, Colour in) const {
    commands.push_back({std::move(shape), in, true});
  }
  void operator()(const Picture::Dots& dots) const {
    add(Dots{thinned(dots.at, view, dots.radius_px), dots.radius_px}, colour);
  }
  void operator()(const Picture::Lines& lines) const {
    Strokes strokes{{}, lines.width_px};
    for (const std::vector<Point2>& line : lines.lines) append_line(strokes.lines, line, view);
    add(std::move(strokes), colour);
  }
  void operator()(const Picture::Circle& circle) const {
    if (!is_finite<2>(circle.centre) || !(circle.radius > 0.0 && circle.radius < 1e9)) return;
    add(Disc{view(circle.centre), circle.radius * view.scale, circle.width_px}, colour);
  }
  void operator()(const Picture::Robot& robot) const {
    if (!robot.pose.is_finite()) return;
    constexpr double smallest = 5.0;
    draw_robot(view(robot.pose.translation()), robot.pose.theta, std::max(robot.radius * view.scale, smallest));
  }
  void operator()(const Picture::Label& label) const {
    if (is_finite<2>(label.at))
      add(Text{view(label.at), label.text, medium, Anchor::start, false, false, true}, colour);
  }
  void draw_robot(Pixel centre, double heading, double radius) const {
    constexpr double half_angle = 145.0 * std::numbers::pi / 180.0;
    const auto corner = [&](double angle, double reach) {
      return Pixel{centre.x + reach * std::cos(heading + angle), centre.y - reach * std::sin(heading + angle)};
    };
    add(Disc{centre, radius, 0.0}, colour);
    add(Area{{corner(0.0, 0.85 * radius), corner(half_angle, 0.62 * radius), corner(std::numbers::pi, 0.2 * radius),
              corner(-half_angle, 0.62 * radius)}},
        {255, 255, 255});
  }
};

// ---- legend ---------------------------------------------------------------------------------------------------------

constexpr double swatch = 22.0;
constexpr double row_height = 20.0;

struct Entry {
  const Picture::Layer* layer;
  Pixel at;  ///< left end of the swatch, at half the letters' height
};

/// Entries side by side, in as many rows as they need.
std::vector<Entry> place_legend(const Picture& picture, double left, double right, double top) {
  std::vector<Entry> entries;
  Pixel at{left, top + 0.5 * row_height};
  for (const Picture::Layer& layer : picture.layers()) {
    if (layer.legend.empty()) continue;
    const double width = swatch + 6.0 + width_of(layer.legend, medium) + 18.0;
    if (at.x > left && at.x + width - 18.0 > right) at = {left, at.y + row_height};
    entries.push_back({&layer, at});
    at.x += width;
  }
  return entries;
}

void draw_swatch(const Entry& entry, std::vector<Command>& commands) {
  const auto add = [&](auto shape) { commands.push_back({std::move(shape), entry.layer->colour, false}); };
  const Pixel middle{entry.at.x + 0.5 * swatch, entry.at.y};
  if (const auto* dots = std::get_if<Picture::Dots>(&entry.layer->shape)) {
    const double radius = std::clamp(dots->radius_px, 2.0, 4.0);
    add(Dots{{{middle.x - 7.0, middle.y + 1.5}, {middle.x, middle.y - 2.0}, {middle.x + 7.0, middle.y + 1.0}}, radius});
  } else if (const auto* lines = std::get_if<Picture::Lines>(&entry.layer->shape)) {
    add(Strokes{{{{entry.at.x + 1.0, middle.y}, {entry.at.x + swatch - 1.0, middle.y}}},
                std::clamp(lines->width_px, 1.5, 4.0)});
  } else if (const auto* circle = std::get_if<Picture::Circle>(&entry.layer->shape)) {
    add(Disc{middle, 5.5, std::clamp(circle->width_px, 1.0, 3.0)});
  } else if (std::holds_alternative<Picture::Robot>(entry.layer->shape)) {
    Drawer{{}, entry.layer->colour, commands}.draw_robot(middle, 0.0, 7.0);
    for (std::size_t i = commands.size() - 2; i < commands.size(); ++i) commands[i].in_plot = false;
  }
}

void draw_legend(const std::vector<Entry>& entries, std::vector<Command>& commands) {
  for (const Entry& entry : entries) {
    draw_swatch(entry, commands);
    commands.push_back(
        {Text{{entry.at.x + swatch + 6.0, entry.at.y + 0.36 * medium}, entry.layer->legend, medium}, ink});
  }
}

// ---- grid, axes, scale bar ------------------------------------------------------------------------------------------

std::string number_text(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  std::string text;
  text::append_fixed(text, value, std::min(decimals, 9));
  return text;
}

void draw_grid(const View& view, std::vector<Command>& commands) {
  const double step = round_step(64.0 / view.scale);
  Strokes grid{{}, 1.0};
  const auto for_each_line = [&](int axis, auto draw) {
    const double first = std::ceil(view.world.lower[axis] / step - 1e-9);
    const auto count = static_cast<int>(std::floor(view.world.upper[axis] / step + 1e-9) - first);
    for (int i = 0; i <= count; ++i) draw((first + i) * step);
  };
  for_each_line(0, [&](double x) {
    const double at = view({x, 0.0}).x;
    grid.lines.push_back({{at, view.plot.top}, {at, view.plot.bottom()}});
    commands.push_back({Text{{at, view.plot.bottom() + 15.0}, number_text(x, step), small, Anchor::middle}, faint_ink});
  });
  for_each_line(1, [&](double y) {
    const double at = view({0.0, y}).y;
    grid.lines.push_back({{view.plot.left, at}, {view.plot.right(), at}});
    commands.push_back({Text{{view.plot.left - 6.0, at + 4.0}, number_text(y, step), small, Anchor::end}, faint_ink});
  });
  commands.push_back({std::move(grid), grid_line});
}

void draw_frame(const View& view, std::vector<Command>& commands) {
  const Rectangle& plot = view.plot;
  commands.push_back({Strokes{{{{plot.left, plot.top},
                                {plot.right(), plot.top},
                                {plot.right(), plot.bottom()},
                                {plot.left, plot.bottom()},
                                {plot.left, plot.top}}},
                              1.0},
                      axis_line});
  const double middle = plot.left + 0.5 * plot.width;
  commands.push_back({Text{{middle, plot.bottom() + 34.0}, "x [m]", small, Anchor::middle}, ink});
  commands.push_back({Text{{14.0, plot.top + 0.5 * plot.height}, "y [m]", small, Anchor::middle, false, true}, ink});
}

/// Under the plot, on the right: there it hides nothing.
void draw_scale_bar(const View& view, std::vector<Command>& commands) {
  const double length = round_step(64.0 / view.scale);
  const double right = view.plot.right();
  const double left = right - length * view.scale;
  const double y = view.plot.bottom() + 31.0;
  commands.push_back(
      {Strokes{{{{left, y - 4.0}, {left, y + 4.0}}, {{left, y}, {right, y}}, {{right, y - 4.0}, {right, y + 4.0}}},
               1.5},
       ink});
  commands.push_back({Text{{left - 7.0, y + 4.0}, number_text(length, length) + " m", small, Anchor::end}, ink});
}

}  // namespace

std::vector<std::span<const Pixel>> pieces_of(std::span<const Pixel> pixels) {
  constexpr std::size_t longest = 200;
  std::vector<std::span<const Pixel>> pieces;
  for (std::size_t begin = 0; begin < pixels.size(); begin += longest)
    pieces.push_back(pixels.subspan(begin, std::min(longest + 1, pixels.size() - begin)));
  return pieces;
}

double width_of(const std::string& text, double size) noexcept {
  // Bytes after the first of a UTF-8 letter take no room.
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.56 * size * static_cast<double>(letters);
}

Drawing lay_out(const Picture& picture) {
  Drawing drawing;
  drawing.width = picture.options().width_px;
  const double right = drawing.width - right_margin;
  const bool titled = !picture.options().title.empty();
  const double legend_top = titled ? 40.0 : 12.0;
  const std::vector<Entry> legend = place_legend(picture, left_margin, right, legend_top);
  const double plot_top = legend.empty() ? legend_top + 2.0 : legend.back().at.y + 0.5 * row_height + 6.0;
  const View view = view_of(picture, left_margin, plot_top, right - left_margin);
  drawing.plot = view.plot;
  drawing.height = view.plot.bottom() + bottom_margin;

  draw_grid(view, drawing.commands);
  for (const Picture::Layer& layer : picture.layers())
    std::visit(Drawer{view, layer.colour, drawing.commands}, layer.shape);
  draw_frame(view, drawing.commands);
  draw_scale_bar(view, drawing.commands);
  draw_legend(legend, drawing.commands);
  if (titled) {
    // A long title is set smaller rather than cut.
    const double width = width_of(picture.options().title, large) * 1.08;
    const double size = std::max(8.0, large * std::min(1.0, (right - left_margin) / width));
    drawing.commands.push_back({Text{{left_margin, 28.0}, picture.options().title, size, Anchor::start, true}, ink});
  }
  return drawing;
}

}  // namespace slamicp::drawing
