// SPDX-License-Identifier: Apache-2.0
#include "io/world_yaml.hpp"

#include <slamicp/error.hpp>

#include "io/text.hpp"

#ifdef SLAMICP_WITH_YAML

#include <algorithm>
#include <optional>

#include <slamicp/geometry/angle.hpp>

#include "io/yaml_fields.hpp"

namespace slamicp {
namespace {

constexpr std::size_t longest_world = 8U << 20U;      // [bytes]
constexpr std::size_t most_world_points = 1'000'000;  // an alias of YAML may stand for a list in many places
constexpr YamlRange size_range{0.0, 1e4, "m", true};
constexpr YamlRange time_range{0.0, 1e6, "s"};

using WorldKeys = std::initializer_list<std::string_view>;

class WorldReader {
 public:
  explicit WorldReader(const std::string& file) : file_(file) {}

  WorldYaml read(const YAML::Node& root) {
    const YamlFields fields =
        take(root, "the world", {"world", "floor_plan", "walls", "pillars", "doors", "obstacles", "people", "routes"});
    WorldYaml result;
    World& world = result.world;
    world.name = fields.words("world");
    if (world.name.empty()) YamlFields::fail("the world has no name", fields.where("world"), "write 'world: NAME'");
    if (fields.has("floor_plan")) {
      const std::string path = fields.words("floor_plan");
      result.floor_plan = std::u8string(path.begin(), path.end());
      result.floor_plan_where = fields.where("floor_plan");
      if (path.empty())
        YamlFields::fail("'floor_plan' is empty", result.floor_plan_where, "name the yaml of a map_server map");
    }
    for (const YAML::Node& item : fields.list("walls")) read_wall(item, world);
    for (const YAML::Node& item : fields.list("pillars")) world.pillars.push_back(read_pillar(item));
    for (const YAML::Node& item : fields.list("doors")) world.doors.push_back(read_door(item));
    for (const YAML::Node& item : fields.list("obstacles")) world.obstacles.push_back(read_obstacle(item));
    for (const YAML::Node& item : fields.list("people")) world.people.push_back(read_person(item));
    for (const YAML::Node& item : fields.list("routes")) read_route(item, world);
    const bool is_empty = result.floor_plan.empty() && world.walls.empty() && world.pillars.empty() &&
                          world.doors.empty() && world.obstacles.empty();
    if (is_empty) YamlFields::fail("nothing stands in this world", fields.where(), "give it walls, or a floor_plan");
    return result;
  }

 private:
  YamlFields take(const YAML::Node& node, std::string_view what, WorldKeys keys) {
    if (++things_ > most_world_points) YamlFields::fail("the world has too much in it", file_, "leave some out");
    return {node, what, keys, file_};
  }

  PointCloud2 points(const YamlFields& fields, std::string_view key, std::size_t fewest) {
    PointCloud2 points = fields.points(key, fewest);
    things_ += points.size();
    return points;
  }

  static double heading(const YamlFields& fields) { return wrap_angle(fields.angle("heading_deg", 0.0)); }

  Box read_box(const YAML::Node& item, std::string_view what) {
    const YamlFields fields = take(item, what, {"centre", "width", "depth", "heading_deg"});
    return {fields.point("centre"), fields.number("width", size_range), fields.number("depth", size_range),
            heading(fields)};
  }

  template <class Round>
  Round read_round(const YAML::Node& item, std::string_view what) {
    const YamlFields fields = take(item, what, {"centre", "radius"});
    return {fields.point("centre"), fields.number("radius", size_range)};
  }
  Circle read_pillar(const YAML::Node& item) { return read_round<Circle>(item, "a pillar"); }

  void read_wall(const YAML::Node& item, World& world) {
    const YamlFields fields = take(item, "a wall", {"segment", "polyline", "closed", "rectangle"});
    const int shapes = fields.has("segment") + fields.has("polyline") + fields.has("rectangle");
    if (shapes != 1)
      YamlFields::fail(shapes == 0 ? "a wall has no shape" : "a wall has more than one shape", fields.where(),
                       "give it one of segment, polyline, rectangle");
    if (fields.has("closed") && !fields.has("polyline"))
      YamlFields::fail("only a polyline may be closed", fields.where("closed"), "leave 'closed' out");
    if (fields.has("rectangle")) {
      for (const Segment& side : sides(read_box(fields.things("rectangle"), "a rectangle")))
        world.walls.push_back(side);
      return;
    }
    const bool is_segment = fields.has("segment");
    PointCloud2 corners = points(fields, is_segment ? "segment" : "polyline", 2);
    if (is_segment && corners.size() > 2)
      YamlFields::fail("a segment has more than two ends", fields.where("segment"), "call it polyline");
    if (fields.flag("closed", false)) {
      if (corners.size() < 3 || corners.front() == corners.back())
        YamlFields::fail("a closed polyline needs three corners, and goes on to its first by itself",
                         fields.where("polyline"), "leave out 'closed', or the last corner");
      corners.push_back(corners.front());
    }
    for (std::size_t k = 1; k < corners.size(); ++k) world.walls.push_back({corners[k - 1], corners[k]});
  }

  Door read_door(const YAML::Node& item) {
    constexpr YamlRange opening{-180.0, 180.0, "deg"};
    const YamlFields fields =
        take(item, "a door", {"name", "hinge", "latch", "open_deg", "mapped_open_deg", "thickness"});
    Door door;
    door.name = fields.words("name", "");
    door.hinge = fields.point("hinge");
    door.latch = fields.point("latch");
    const double width = (door.latch - door.hinge).norm();
    if (!(width >= 0.01 && width <= 100.0))
      YamlFields::fail("the door is " + std::to_string(width) + " m wide", fields.where("latch"),
                       "set 'latch' where the leaf ends while the door is closed, 0.01 to 100 m from the hinge");
    const double open_deg = fields.number("open_deg", opening, 0.0);
    door.opening = open_deg * rad_per_deg;
    door.mapped_opening = fields.number("mapped_open_deg", opening, open_deg) * rad_per_deg;
    door.thickness = fields.number("thickness", size_range, door.thickness);
    return door;
  }

  PlacedObstacle read_obstacle(const YAML::Node& item) {
    const YamlFields fields = take(item, "an obstacle", {"name", "boxes", "cylinders"});
    PlacedObstacle obstacle;
    obstacle.name = fields.words("name", "");
    for (const YAML::Node& box : fields.list("boxes")) obstacle.boxes.push_back(read_box(box, "a box"));
    for (const YAML::Node& round : fields.list("cylinders"))
      obstacle.cylinders.push_back(read_round<Cylinder>(round, "a cylinder"));
    if (obstacle.boxes.empty() && obstacle.cylinders.empty())
      YamlFields::fail("the obstacle has neither boxes nor cylinders", fields.where(),
                       "write 'boxes: [{centre: [x, y], width: 0.4, depth: 0.3}]' or so");
    return obstacle;
  }

  Person read_person(const YAML::Node& item) {
    const YamlFields fields = take(item, "a person",
                                   {"name", "way", "loop", "speed", "start", "pause", "heading_deg", "seen_as",
                                    "leg_radius", "leg_distance", "step_length", "body_radius"});
    constexpr std::string_view shapes[] = {"legs", "body"};
    Person person;
    person.name = fields.words("name", "");
    person.way = points(fields, "way", 1);
    person.is_loop = fields.flag("loop", false);
    person.speed = fields.number("speed", {0.0, 20.0, "m/s", true}, person.speed);
    person.start = fields.number("start", time_range, person.start);
    person.pause = fields.number("pause", time_range, person.pause);
    person.heading = heading(fields);
    person.shape = fields.choice("seen_as", shapes, 0) == 0 ? PersonShape::legs : PersonShape::body;
    constexpr YamlRange limb{0.0, 5.0, "m", true};
    person.leg_radius = fields.number("leg_radius", limb, person.leg_radius);
    person.leg_distance = fields.number("leg_distance", {0.0, 5.0, "m"}, person.leg_distance);
    person.step_length = fields.number("step_length", {0.01, 5.0, "m"}, person.step_length);
    person.body_radius = fields.number("body_radius", limb, person.body_radius);
    if (const std::string problem = person.problem(); !problem.empty())
      YamlFields::fail("a person's " + problem, fields.where("way"), "mend the way");
    return person;
  }

  void read_route(const YAML::Node& item, World& world) {
    const YamlFields fields = take(item, "a route", {"name", "waypoints"});
    Route route{fields.words("name"), points(fields, "waypoints", 2)};
    const bool is_double = std::any_of(world.routes.begin(), world.routes.end(),
                                       [&](const Route& other) { return other.name == route.name; });
    if (route.name.empty() || is_double)
      YamlFields::fail(is_double ? "there are two routes '" + route.name + "'" : "the route's name is empty",
                       fields.where("name"), "give each route a name of its own");
    world.routes.push_back(std::move(route));
  }

  const std::string& file_;
  std::size_t things_ = 0;
};

}  // namespace

WorldYaml parse_world_yaml(std::string_view text, const std::string& name) {
  const std::string mend = "a world begins with the line 'world: NAME'";
  if (text.size() > longest_world) throw Error("the file is too long for a world", name, mend);
  try {
    const YAML::Node root = YAML::Load(std::string(text));
    const bool is_world = root.IsMap() && root["world"].IsDefined();
    const bool is_map = root.IsMap() && !is_world && root["image"].IsDefined();
    if (is_map) throw Error("is a map_server map, no world", name, "write a world with 'floor_plan: " + name + "'");
    if (!is_world) throw Error("is no world", name, mend);
    return WorldReader(name).read(root);
  } catch (const YAML::Exception& problem) {
    throw Error("is no YAML: " + problem.msg, place_of(problem.mark, name),
                "mend the line, or the one before; " + mend);
  }
}

}  // namespace slamicp

#else

namespace slamicp {

WorldYaml parse_world_yaml(std::string_view, const std::string& name) {
  throw Error("this build reads no worlds", name, "build with yaml-cpp (Debian: libyaml-cpp-dev)");
}

}  // namespace slamicp

#endif
