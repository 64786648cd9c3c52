// SPDX-License-Identifier: Apache-2.0
#include <slamicp/error.hpp>
#include <slamicp/io/chart.hpp>

#include "io/chart_layout.hpp"

namespace slamicp {

std::string ChartOptions::problem() const {
  if (!(width_px >= 300.0 && width_px <= 4000.0)) return "width_px is not in 300 .. 4000";
  if (!(height_px >= 150.0 && height_px <= 4000.0)) return "height_px is not in 150 .. 4000";
  if (!(png_scale >= 0.5 && png_scale <= 8.0)) return "png_scale is not in 0.5 .. 8";
  return {};
}

Chart::Chart(ChartOptions options) : options_(std::move(options)) {
  if (const std::string problem = options_.problem(); !problem.empty()) throw Error(problem, "ChartOptions");
}

Chart& Chart::line(std::span<const Point2> points, Colour colour, double width_px, std::string legend) {
  series_.push_back({{points.begin(), points.end()}, colour, width_px, true, std::move(legend)});
  return *this;
}

Chart& Chart::dots(std::span<const Point2> points, Colour colour, double radius_px, std::string legend) {
  series_.push_back({{points.begin(), points.end()}, colour, radius_px, false, std::move(legend)});
  return *this;
}

Chart& Chart::band(double from, double to, Colour colour) {
  bands_.push_back({from, to, colour});
  return *this;
}

Chart& Chart::mark(double x, std::string text) {
  marks_.push_back({x, std::move(text)});
  return *this;
}

std::string Chart::svg() const { return drawing::to_svg(drawing::lay_out(*this)); }

void Chart::save(const std::filesystem::path& path) const {
  drawing::save(drawing::lay_out(*this), options_.png_scale, path);
}

}  // namespace slamicp
