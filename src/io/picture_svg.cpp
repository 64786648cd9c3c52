// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "io/drawing.hpp"
#include "io/text.hpp"

namespace slamicp::drawing {
namespace {

/// Two decimals at most, no needless zeros: most of a picture's bytes are coordinates.
void append_pixel(std::string& out, double value) {
  const std::size_t begin = out.size();
  text::append_fixed(out, value, 2);
  if (out.find('.', begin) == std::string::npos) return;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
}

/// XML's own letters escaped, letters that XML forbids left out.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

void append_colour(std::string& out, const char* name, Colour colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  out.append(" ").append(name).append("=\"#");
  for (const unsigned value : {unsigned{colour.red}, unsigned{colour.green}, unsigned{colour.blue}})
    (out += digits[value >> 4]) += digits[value & 15];
  out += '"';
  if (colour.opacity >= 1.0) return;
  out.append(" ").append(name).append("-opacity=\"");
  append_pixel(out, colour.opacity);
  out += '"';
}

void append_attribute(std::string& out, const char* name, double value) {
  out.append(" ").append(name).append("=\"");
  append_pixel(out, value);
  out += '"';
}

void append_move(std::string& out, char command, Pixel to) {
  out += command;
  append_pixel(out, to.x);
  out += ' ';
  append_pixel(out, to.y);
}

constexpr std::size_t longest_path = 200;

struct SvgWriter {
  std::string& out;
  Colour colour;

  void append_stroke_style(double width) const {
    out += " fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    append_attribute(out, "stroke-width", width);
    append_colour(out, "stroke", {colour.red, colour.green, colour.blue});
    // On the whole, so that what overlaps within one shape does not show.
    if (colour.opacity < 1.0) append_attribute(out, "opacity", colour.opacity);
  }
  /// A dot is a line of no length with round ends: the shortest there is.
  void operator()(const Dots& dots) const {
    if (dots.at.empty()) return;
    out += "<path";
    append_stroke_style(2.0 * dots.radius);
    out += " d=\"";
    for (const Pixel& pixel : dots.at) {
      append_move(out, 'M', pixel);
      out += "h0";
    }
    out += "\"/>\n";
  }
  void append_line(std::span<const Pixel> line) const {
    for (std::size_t i = 0; i < line.size(); ++i) append_move(out, i == 0 ? 'M' : 'L', line[i]);
  }
  void operator()(const Strokes& strokes) const {
    if (strokes.lines.empty()) return;
    out += "<g";
    append_stroke_style(strokes.width);
    out += ">\n";
    std::size_t in_path = 0;
    for (const std::vector<Pixel>& line : strokes.lines)
      for (const std::span<const Pixel> piece : pieces_of(line)) {
        if (in_path == 0) out += "<path d=\"";
        append_line(piece);
        in_path += piece.size();
        if (in_path < longest_path) continue;
        out += "\"/>\n";
        in_path = 0;
      }
    out += in_path > 0 ? "\"/>\n</g>\n" : "</g>\n";
  }
  void operator()(const Area& area) const {
    out += "<path";
    append_colour(out, "fill", colour);
    out += " d=\"";
    for (std::size_t i = 0; i < area.corners.size(); ++i) append_move(out, i == 0 ? 'M' : 'L', area.corners[i]);
    out += "Z\"/>\n";
  }
  void operator()(const Disc& disc) const {
    out += "<circle";
    append_attribute(out, "cx", disc.centre.x);
    append_attribute(out, "cy", disc.centre.y);
    append_attribute(out, "r", disc.radius);
    if (disc.rim > 0.0) {
      out += " fill=\"none\"";
      append_colour(out, "stroke", colour);
      append_attribute(out, "stroke-width", disc.rim);
    } else {
      append_colour(out, "fill", colour);
      out += " stroke=\"#ffffff\" stroke-width=\"1\"";
    }
    out += "/>\n";
  }
  void operator()(const Text& text) const {
    constexpr std::string_view anchors[] = {"start", "middle", "end"};
    out += "<text";
    append_attribute(out, "x", text.at.x);
    append_attribute(out, "y", text.at.y);
    append_attribute(out, "font-size", text.size);
    append_colour(out, "fill", colour);
    if (text.anchor != Anchor::start)
      out.append(" text-anchor=\"").append(anchors[static_cast<std::size_t>(text.anchor)]).append("\"");
    if (text.bold) out += " font-weight=\"bold\"";
    if (text.halo) out += " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    if (text.upwards) {
      out += " transform=\"rotate(-90";
      out += ' ';
      append_pixel(out, text.at.x);
      out += ' ';
      append_pixel(out, text.at.y);
      out += ")\"";
    }
    out += '>' + escaped(text.text) + "</text>\n";
  }
};

}  // namespace

std::string to_svg(const Drawing& drawing) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  append_attribute(out, "width", drawing.width);
  append_attribute(out, "height", drawing.height);
  out += " viewBox=\"0 0 ";
  append_pixel(out, drawing.width);
  out += ' ';
  append_pixel(out, drawing.height);
  out += "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<clipPath id=\"plot\"><rect";
  append_attribute(out, "x", drawing.plot.left);
  append_attribute(out, "y", drawing.plot.top);
  append_attribute(out, "width", drawing.plot.width);
  append_attribute(out, "height", drawing.plot.height);
  out += "/></clipPath>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  bool in_plot = false;
  for (const Command& command : drawing.commands) {
    if (command.in_plot != in_plot) out += command.in_plot ? "<g clip-path=\"url(#plot)\">\n" : "</g>\n";
    in_plot = command.in_plot;
    std::visit(SvgWriter{out, command.colour}, command.shape);
  }
  if (in_plot) out += "</g>\n";
  return out + "</svg>\n";
}

}  // namespace slamicp::drawing
