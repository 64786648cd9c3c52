// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/output_file.hpp>

#include "io/occupancy_cells.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

OccupancyImage load_image(const OccupancyMapHeader& header, const std::filesystem::path& yaml) {
  const std::filesystem::path path = yaml.parent_path() / header.image;  // or image alone, where it is absolute
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw Error("its image " + text::name_of(header.image) + " is not there", text::name_of(yaml),
                "put it beside the yaml, or mend the line 'image'");
  const std::string bytes = text::read_file(path);
  const std::string name = text::name_of(path);
  if (bytes.starts_with("\x89PNG")) return parse_png(bytes, name);
  if (bytes.starts_with('P') || bytes.empty()) return parse_pgm(bytes, name);
  throw Error("is neither PGM nor PNG", name, "convert it to PGM, P5, or to PNG");
}

void add_warnings(OccupancyMap& map) {
  if (const double yaw = map.header.T_map_grid.theta; std::abs(yaw) > 1e-6) {
    std::string turn;
    text::append_fixed(turn, yaw * deg_per_rad, 2);
    map.warnings.push_back("the origin is turned by " + turn +
                           " deg: we do so, but AMCL and other tools of ROS do not");
  }
  if (count_cells(map.grid).occupied == 0) map.warnings.emplace_back("no cell is occupied");
}

/// As every reader of YAML takes it for a number: no exponent, at least one decimal.
std::string yaml_number(double number) {
  std::string text;
  text::append_fixed(text, number, 12);
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text + '0' : text;
}

/// In quotes where it must be.
std::string yaml_text(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+/";
  if (text.find_first_not_of(plain) == std::string::npos && text.find_first_of("-.+") != 0) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string yaml_of(const OccupancyGrid& grid, const std::string& image) {
  const Pose2& origin = grid.T_map_grid;
  return "image: " + yaml_text(image) + "\nmode: trinary\nresolution: " + yaml_number(grid.resolution) + "\norigin: [" +
         yaml_number(origin.x) + ", " + yaml_number(origin.y) + ", " + yaml_number(origin.theta) +
         "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace

OccupancyMap load_occupancy_map(const std::filesystem::path& path) {
  const std::string ending = text::ending_of(path);
  if (ending == ".pgm" || ending == ".png")
    throw Error("is the image of a map: it has no scale", text::name_of(path), "give the yaml that names it");
  OccupancyMap map;
  map.name = text::name_of(path);
  map.header = parse_occupancy_yaml(text::read_file(path), map.name);
  OccupancyImage image = load_image(map.header, path);
  map.format = image.format;
  map.warnings = std::move(image.warnings);
  map.grid = cells_of(image, map.header, map.warnings);
  add_warnings(map);
  return map;
}

void save_occupancy_map(const std::filesystem::path& path, const OccupancyGrid& grid) {
  if (const std::string problem = grid.problem(); !problem.empty())
    throw Error(problem, "OccupancyGrid", "make it with GridBuilder or to_occupancy_grid");
  std::filesystem::path image = path;
  image.replace_extension(".pgm");
  OutputFile image_file(image);
  OutputFile yaml_file(path);
  image_file.write(pgm_bytes(grid));
  yaml_file.write(yaml_of(grid, text::name_of(image.filename())));
  image_file.commit();
  yaml_file.commit();
}

}  // namespace slamicp
