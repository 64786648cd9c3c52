// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <slamicp/io/picture.hpp>

/// A picture laid out: drawing commands in pixels, x to the right, y down. Both writers, SVG and PNG, take these.
namespace slamicp::drawing {

struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

struct Rectangle {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const noexcept { return left + width; }
  double bottom() const noexcept { return top + height; }
};

struct Dots {
  std::vector<Pixel> at;
  double radius = 1.0;
};

struct Strokes {
  std::vector<std::vector<Pixel>> lines;
  double width = 1.0;
};

/// A filled polygon with a thin white rim, so that it stands out from what lies below.
struct Area {
  std::vector<Pixel> corners;
};

struct Disc {
  Pixel centre;
  double radius = 1.0;
  double rim = 0.0;  ///< width of the line; 0: filled, with a thin white rim
};

enum class Anchor { start, middle, end };

struct Text {
  Pixel at;  ///< on the base line
  std::string text;
  double size = 12.0;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees
  bool halo = false;     ///< white around the letters
};

struct Command {
  std::variant<Dots, Strokes, Area, Disc, Text> shape;
  Colour colour;
  bool in_plot = false;  ///< cut at the plot's border
};

struct Drawing {
  double width = 0.0;
  double height = 0.0;
  Rectangle plot;
  std::vector<Command> commands;
};

// The colours of what frames a picture.
inline constexpr Colour ink{45, 50, 58};
inline constexpr Colour faint_ink{105, 112, 122};
inline constexpr Colour grid_line{228, 231, 236};
inline constexpr Colour axis_line{190, 196, 204};

Drawing lay_out(const Picture& picture);

std::string to_svg(const Drawing& drawing);

/// @param name  the file's name, for messages
std::string to_png(const Drawing& drawing, double scale, const std::string& name);

/// Writes it by the file name's ending, .svg or .png. Throws Error.
void save(const Drawing& drawing, double png_scale, const std::filesystem::path& path);

/// A long line or cloud in pieces of at most 200, each starting where the last one ended. Renderers take quadratic time
/// for one long path that crosses itself, as the path of a robot does.
std::vector<std::span<const Pixel>> pieces_of(std::span<const Pixel> pixels);

/// About how wide the text is, in any sans-serif face.
double width_of(const std::string& text, double size) noexcept;

}  // namespace slamicp::drawing
