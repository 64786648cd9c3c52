// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <slamicp/io/picture.hpp>

namespace slamicp {

struct ChartOptions {
  std::string title = {};
  std::string x_label = {};  ///< with its unit
  std::string y_label = {};
  /// Where x counts things rather than measures: their names, the first at x = 0.
  std::vector<std::string> x_names = {};
  bool logarithmic = false;  ///< y by powers of ten; what is not above 0 is left out
  double width_px = 900.0;   ///< of the whole chart, in SVG pixels, 300 .. 4000
  double height_px = 340.0;  ///< 150 .. 4000
  double png_scale = 2.0;    ///< PNG pixels per SVG pixel, 0.5 .. 8

  /// The first rule broken, in words; empty if none is.
  std::string problem() const;
};

/// A value over another one: lines, dots, places marked by a letter. y starts at 0, or at a power of ten.
///
/// Things are drawn in the order they are added; one with a legend gets an entry over the plot.
class Chart {
 public:
  /// Throws Error with options.problem().
  explicit Chart(ChartOptions options = {});

  /// A line from point to point; a NaN breaks it.
  Chart& line(std::span<const Point2> points, Colour colour, double width_px = 1.3, std::string legend = {});

  Chart& dots(std::span<const Point2> points, Colour colour, double radius_px = 4.0, std::string legend = {});

  /// A stretch of x, coloured from bottom to top behind all else.
  Chart& band(double from, double to, Colour colour);

  /// An upright line at x with a few letters on top.
  Chart& mark(double x, std::string text);

  std::string svg() const;

  /// Writes `.svg` or `.png` by the file name's ending, as Picture does. Throws Error.
  void save(const std::filesystem::path& path) const;

  struct Series {
    std::vector<Point2> points;
    Colour colour;
    double size_px;  ///< a line's width, a dot's radius
    bool is_line;
    std::string legend;
  };
  struct Band {
    double from;
    double to;
    Colour colour;
  };
  struct Mark {
    double x;
    std::string text;
  };

  const std::vector<Series>& series() const noexcept { return series_; }
  const std::vector<Band>& bands() const noexcept { return bands_; }
  const std::vector<Mark>& marks() const noexcept { return marks_; }
  const ChartOptions& options() const noexcept { return options_; }

 private:
  ChartOptions options_;
  std::vector<Series> series_;
  std::vector<Band> bands_;
  std::vector<Mark> marks_;
};

}  // namespace slamicp
