// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/geometry/trajectory.hpp>

namespace slamicp {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  double opacity = 1.0;  ///< 0 unseen .. 1 opaque
};

/// The colours of our pictures: told apart by all common kinds of colour vision, outliers the loudest.
namespace colours {
inline constexpr Colour map{58, 110, 165};
inline constexpr Colour inlier{34, 160, 84};
inline constexpr Colour outlier{214, 39, 40};
inline constexpr Colour path{70, 78, 90};
inline constexpr Colour truth{150, 156, 166};
inline constexpr Colour robot{240, 145, 30};
inline constexpr Colour obstacle{148, 62, 165};
inline constexpr Colour ellipse{0, 130, 140};
inline constexpr Colour blind{200, 0, 120};
}  // namespace colours

struct PictureOptions {
  std::string title = {};
  double width_px = 900.0;           ///< of the whole picture, in SVG pixels, 300 .. 4000; the height follows
  double largest_height_px = 900.0;  ///< of the plot; a tall world gets a wider plot around it instead
  std::optional<Bounds<2>> bounds = std::nullopt;  ///< what to show [m]; default: all that is drawn and a margin
  double png_scale = 2.0;                          ///< PNG pixels per SVG pixel, 0.5 .. 8

  /// The first rule broken, in words; empty if none is.
  std::string problem() const;
};

/// A picture in metric coordinates, x to the right, y up, both to the same scale.
///
/// Things are drawn in the order they are added, later ones on top. A thing with a legend gets an entry over the plot.
/// Grid, axes and a scale bar come by themselves. The same list of drawing commands makes `.svg` and `.png`.
class Picture {
 public:
  explicit Picture(PictureOptions options = {});

  /// Points as dots. Two dots on the same place of the picture become one: 50,000 points stay below 1 MB of SVG.
  Picture& points(std::span<const Point2> points, Colour colour, double radius_px = 1.2, std::string legend = {});

  /// A line from point to point.
  Picture& polyline(std::span<const Point2> points, Colour colour, double width_px = 1.5, std::string legend = {});

  /// The way of a trajectory.
  Picture& path(std::span<const StampedPose> trajectory, Colour colour, double width_px = 1.5, std::string legend = {});

  struct Segment {
    Point2 from;
    Point2 to;
  };
  Picture& segments(std::span<const Segment> segments, Colour colour, double width_px = 1.5, std::string legend = {});

  /// @param radius  [m]
  Picture& circle(const Point2& centre, double radius, Colour colour, double width_px = 1.5, std::string legend = {});

  struct Ellipse {
    Point2 centre;
    Matrix<2, 2> covariance;  ///< of the position [m^2]
  };
  /// Where positions are with 95 %: half axes of 2.45 standard deviations (chi-squared with two degrees of freedom).
  /// What is no covariance is not drawn.
  /// @param magnified  so many times as large, > 0; to be named in the legend
  Picture& ellipses(std::span<const Ellipse> ellipses, double magnified, Colour colour, double width_px = 1.2,
                    std::string legend = {});

  /// A robot as a disc with a wedge that shows its heading. @param radius  [m]; never drawn smaller than 5 px
  Picture& robot(const Pose2& pose, double radius, Colour colour = colours::robot, std::string legend = {});

  /// Text that starts at a point.
  Picture& label(const Point2& at, std::string text, Colour colour = colours::path);

  std::string svg() const;

  /// Writes `.svg` or `.png` by the file name's ending. Throws Error; a build without Cairo has no `.png`.
  void save(const std::filesystem::path& path) const;

  struct Dots {
    std::vector<Point2> at;
    double radius_px;
  };
  struct Lines {
    std::vector<std::vector<Point2>> lines;
    double width_px;
  };
  struct Circle {
    Point2 centre;
    double radius;
    double width_px;
  };
  struct Robot {
    Pose2 pose;
    double radius;
  };
  struct Label {
    Point2 at;
    std::string text;
  };
  /// One thing in the picture, in metres.
  struct Layer {
    std::variant<Dots, Lines, Circle, Robot, Label> shape;
    Colour colour;
    std::string legend;  ///< empty: no entry
  };

  const std::vector<Layer>& layers() const noexcept { return layers_; }
  const PictureOptions& options() const noexcept { return options_; }

 private:
  Picture& add(Layer layer);

  PictureOptions options_;
  std::vector<Layer> layers_;
};

}  // namespace slamicp
