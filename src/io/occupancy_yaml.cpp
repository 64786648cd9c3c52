// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/io/occupancy_map_file.hpp>

#include "io/text.hpp"

#ifdef SLAMICP_WITH_YAML

#include "io/yaml_fields.hpp"

namespace slamicp {
namespace {

constexpr std::size_t longest_yaml = 65536;  // a map's has ten lines; a larger file is something else

class YamlReader {
 public:
  YamlReader(const YAML::Node& root, const std::string& name) : root_(root), name_(name) {}

  OccupancyMapHeader read() const {
    OccupancyMapHeader header;
    header.image = image();
    header.resolution = number(scalar("resolution"), "resolution");
    if (header.resolution <= 0.0 || header.resolution > 1000.0)
      fail("resolution", "resolution is " + scalar("resolution").Scalar() + " m", "give the side of a cell [m]: 0.05");
    header.T_map_grid = origin();
    header.negate = negate();
    header.occupied_threshold = threshold("occupied_thresh");
    header.free_threshold = threshold("free_thresh");
    if (header.occupied_threshold <= header.free_threshold)
      fail("occupied_thresh", "occupied_thresh is not above free_thresh", "ROS has 0.65 and 0.196");
    header.mode = mode();
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& what, const std::string& mend) const {
    const YAML::Node node = root_[key];
    throw Error(what, node.IsDefined() ? place_of(node.Mark(), name_) : name_, mend);
  }

  YAML::Node node(const std::string& key) const {
    const YAML::Node node = root_[key];
    if (!node.IsDefined() || node.IsNull())
      fail(key, "there is no '" + key + "'",
           "a map's yaml has image, resolution, origin, negate, occupied_thresh, free_thresh");
    return node;
  }

  YAML::Node scalar(const std::string& key) const {
    const YAML::Node node = this->node(key);
    if (!node.IsScalar()) fail(key, key + " is not a single value", "write '" + key + ": VALUE'");
    return node;
  }

  double number(const YAML::Node& node, const std::string& key) const {
    const std::optional<double> number = text::to_number<double>(node.Scalar());
    if (!number || !std::isfinite(*number))
      fail(key, key + " is not a number: " + text::quoted(node.Scalar()), "write a number with a point: 0.05");
    return *number;
  }

  std::filesystem::path image() const {
    const std::string image = scalar("image").Scalar();
    if (image.empty()) fail("image", "image is empty", "name the map's .pgm or .png");
    return {std::u8string(image.begin(), image.end())};
  }

  Pose2 origin() const {
    const YAML::Node origin = node("origin");
    const std::string mend = "write 'origin: [x, y, yaw]' [m, m, rad]";
    if (!origin.IsSequence() || origin.size() != 3) fail("origin", "origin has not three numbers", mend);
    double value[3];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!origin[k].IsScalar()) fail("origin", "origin has not three numbers", mend);
      value[k] = number(origin[k], "origin");
    }
    return {value[0], value[1], wrap_angle(value[2])};
  }

  bool negate() const {
    const std::string word = scalar("negate").Scalar();
    if (word == "0" || word == "false" || word == "False") return false;
    if (word == "1" || word == "true" || word == "True") return true;
    fail("negate", "negate is " + text::quoted(word), "write 0, or 1 where white is occupied");
  }

  double threshold(const std::string& key) const {
    const double value = number(scalar(key), key);
    if (value < 0.0 || value > 1.0)
      fail(key, key + " is " + scalar(key).Scalar() + ", no probability", "write a number from 0 to 1");
    return value;
  }

  OccupancyMode mode() const {
    if (!root_["mode"].IsDefined()) return OccupancyMode::trinary;
    const std::string word = scalar("mode").Scalar();
    if (word == "trinary") return OccupancyMode::trinary;
    if (word == "scale") return OccupancyMode::scale;
    if (word == "raw") return OccupancyMode::raw;
    fail("mode", "there is no mode " + text::quoted(word), "write trinary, scale or raw");
  }

  const YAML::Node& root_;
  const std::string& name_;
};

}  // namespace

OccupancyMapHeader parse_occupancy_yaml(std::string_view text, const std::string& name) {
  const std::string mend = "give the yaml of a map_server map";
  if (text.size() > longest_yaml) throw Error("the file is too long for a map's yaml", name, mend);
  try {
    const YAML::Node root = YAML::Load(std::string(text));
    if (!root.IsMap()) throw Error("no 'key: value' lines", name, mend);
    if (root["world"].IsDefined() && !root["image"].IsDefined())
      throw Error("is a world of the simulator, no map", name,
                  "make a map of it: slamicp simulate --world " + name + " --out LOG --map-out MAP");
    return YamlReader(root, name).read();
  } catch (const YAML::Exception& problem) {
    throw Error("is no YAML: " + problem.msg, place_of(problem.mark, name), mend);
  }
}

}  // namespace slamicp

#else

namespace slamicp {

OccupancyMapHeader parse_occupancy_yaml(std::string_view, const std::string& name) {
  throw Error("this build reads no map_server maps", name, "build with yaml-cpp (Debian: libyaml-cpp-dev)");
}

}  // namespace slamicp

#endif
