// SPDX-License-Identifier: Apache-2.0
#include <slamicp/error.hpp>

#include "io/drawing.hpp"

#ifdef SLAMICP_WITH_PNG

#include <cairo.h>
#include <cmath>
#include <memory>
#include <numbers>

namespace slamicp::drawing {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

struct CairoWriter {
  cairo_t* context;
  Colour colour;

  void ink(Colour in) const {
    cairo_set_source_rgba(context, in.red / 255.0, in.green / 255.0, in.blue / 255.0, in.opacity);
  }
  /// What overlaps within one shape is not to show, even where the shape is transparent.
  template <class Draw>
  void in_one_layer(Draw draw) const {
    const bool transparent = colour.opacity < 1.0;
    if (transparent) cairo_push_group(context);
    ink({colour.red, colour.green, colour.blue});
    draw();
    if (!transparent) return;
    cairo_pop_group_to_source(context);
    cairo_paint_with_alpha(context, colour.opacity);
  }
  void operator()(const Dots& dots) const {
    in_one_layer([&] {
      cairo_set_line_width(context, 2.0 * dots.radius);
      for (const std::span<const Pixel> piece : pieces_of(dots.at)) {
        for (const Pixel& pixel : piece) {
          cairo_move_to(context, pixel.x, pixel.y);
          cairo_close_path(context);
        }
        cairo_stroke(context);
      }
    });
  }
  void operator()(const Strokes& strokes) const {
    in_one_layer([&] {
      cairo_set_line_width(context, strokes.width);
      for (const std::vector<Pixel>& line : strokes.lines)
        for (const std::span<const Pixel> piece : pieces_of(line)) {
          for (const Pixel& pixel : piece) cairo_line_to(context, pixel.x, pixel.y);
          cairo_stroke(context);
        }
    });
  }
  void operator()(const Area& area) const {
    ink(colour);
    for (const Pixel& pixel : area.corners) cairo_line_to(context, pixel.x, pixel.y);
    cairo_close_path(context);
    cairo_fill(context);
  }
  void operator()(const Disc& disc) const {
    cairo_new_path(context);
    cairo_arc(context, disc.centre.x, disc.centre.y, disc.radius, 0.0, 2.0 * std::numbers::pi);
    ink(colour);
    if (disc.rim <= 0.0) {
      cairo_fill_preserve(context);
      ink({255, 255, 255});
    }
    cairo_set_line_width(context, disc.rim > 0.0 ? disc.rim : 1.0);
    cairo_stroke(context);
  }
  void operator()(const Text& text) const {
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, text.size);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.text.c_str(), &extents);
    const double share = text.anchor == Anchor::start ? 0.0 : text.anchor == Anchor::middle ? 0.5 : 1.0;
    cairo_save(context);
    cairo_translate(context, text.at.x, text.at.y);
    if (text.upwards) cairo_rotate(context, -0.5 * std::numbers::pi);
    cairo_move_to(context, -share * extents.x_advance, 0.0);
    if (text.halo) {
      cairo_text_path(context, text.text.c_str());
      ink({255, 255, 255});
      cairo_set_line_width(context, 3.0);
      cairo_stroke(context);
      cairo_move_to(context, -share * extents.x_advance, 0.0);
    }
    ink(colour);
    cairo_show_text(context, text.text.c_str());
    cairo_restore(context);
    cairo_new_path(context);
  }
};

cairo_status_t append_bytes(void* out, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void draw(const Drawing& drawing, cairo_t* context) {
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  cairo_paint(context);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  for (const Command& command : drawing.commands) {
    cairo_save(context);
    if (command.in_plot) {
      cairo_rectangle(context, drawing.plot.left, drawing.plot.top, drawing.plot.width, drawing.plot.height);
      cairo_clip(context);
    }
    std::visit(CairoWriter{context, command.colour}, command.shape);
    cairo_restore(context);
  }
}

}  // namespace

std::string to_png(const Drawing& drawing, double scale, const std::string& name) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(drawing.width * scale)),
                                 static_cast<int>(std::lround(drawing.height * scale))),
      &cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), &cairo_destroy);
  cairo_scale(context.get(), scale, scale);
  draw(drawing, context.get());
  std::string png;
  cairo_status_t status = cairo_status(context.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_write_to_png_stream(surface.get(), append_bytes, &png);
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status), name,
                "write .svg instead, or a smaller picture");
  return png;
}

}  // namespace slamicp::drawing

#else

namespace slamicp::drawing {

std::string to_png(const Drawing&, double, const std::string& name) {
  throw Error("this slamicp was built without Cairo and writes no PNG", name,
              "write .svg instead, or build with Cairo and -DSLAMICP_WITH_PNG=ON");
}

}  // namespace slamicp::drawing

#endif
