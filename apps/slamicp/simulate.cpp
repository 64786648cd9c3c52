// SPDX-License-Identifier: Apache-2.0
// slamicp simulate: a seeded run of the simulator.
#include <algorithm>
#include <array>
#include <memory>

#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/io/world_file.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/crowd.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "output.hpp"
#include "simulated_picture.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

const std::array<std::string, 4> layout_names = {"crossing", "along", "groups", "random-walk"};
const std::array<std::string, 3> lidar_names = {"hokuyo", "exact-hokuyo", "real-hokuyo"};

struct SimulateWords {
  std::string out, world = "corridor", route, obstacle, truth, map_out, picture, json;
  std::string lidar = lidar_names[0], robot = "differential", layout = layout_names[0];
  CrowdOptions crowd{.people = 0};
  DriveOptions drive;
};

World world_of(const SimulateWords& words) {
  if (is_map_server(words.world)) return load_world(file_named(words.world));
  if (words.world != "corridor")
    throw Error("there is no world '" + words.world + "'", "--world",
                "the worlds are: corridor, and those of files: FILE.yaml");
  return corridor_world();
}

World with_what_came_later(World world, const SimulateWords& words, const Route& way) {
  if (!words.obstacle.empty()) {
    if (words.world != "corridor")
      throw Error("obstacle '" + words.obstacle + "' stands in the corridor only", "--obstacle",
                  "write what stands in " + words.world + " into its 'obstacles'");
    world = with_obstacle(std::move(world), corridor_obstacle(words.obstacle));
  }
  CrowdOptions crowd = words.crowd;
  crowd.seed = words.drive.seed;
  const auto layout = std::find(layout_names.begin(), layout_names.end(), words.layout);
  crowd.layout = static_cast<CrowdLayout>(layout - layout_names.begin());
  return crowd.people == 0 ? world : with_crowd(std::move(world), way.waypoints, crowd);
}

Route route_of(const World& world, const std::string& name) {
  if (name.empty() && !world.routes.empty()) return world.routes.front();
  if (name.empty())
    throw Error("this world has no routes", "--world",
                "give it one: 'routes: [{name: patrol, waypoints: [[x, y], [x, y]]}]'");
  return route(world, name);
}

DriveOptions drive_of(const SimulateWords& words) {
  DriveOptions drive = words.drive;
  if (words.lidar == "exact-hokuyo") drive.lidar = hokuyo_utm30lx(0.0);
  if (words.lidar == "real-hokuyo") drive.lidar = real_hokuyo_utm30lx();
  return drive;
}

void run(const SimulateWords& words) {
  const World site = world_of(words);
  const Route way = route_of(site, words.route);
  const World world = with_what_came_later(site, words, way);
  const DriveOptions options = drive_of(words);
  const SimulatedRun drive = words.robot == "omni" ? simulate_drive(world, way.waypoints, apr02(), options)
                                                   : simulate_drive(world, way.waypoints, options);
  save_scan_log(file_named(words.out), drive.scans);
  if (!words.truth.empty()) save_trajectory(file_named(words.truth), drive.truth);
  std::size_t map_points = 0;
  if (!words.map_out.empty()) {
    Random random(words.drive.seed);
    const PointCloud2 map = sample_map(world, random);  // what the map was before obstacles and people came
    map_points = map.size();
    save_cloud(file_named(words.map_out), map);
  }
  if (!words.picture.empty()) save_simulated_picture(words.picture, world, drive);
  const Pose2& start = drive.truth.front().pose;
  write_json(words.json, {{"verb", "simulate"},
                          {"out", words.out},
                          {"world", words.world},
                          {"route", way.name},
                          {"obstacle", words.obstacle},
                          {"people", world.people.size()},
                          {"lidar", words.lidar},
                          {"robot", words.robot},
                          {"speed", words.drive.speed},
                          {"seed", words.drive.seed},
                          {"scans", drive.scans.size()},
                          {"map_points", map_points},
                          {"initial_pose", to_json(start)}});
  Talk{words.json}(format("%zu scans at %.2f m/s -> %s; the robot starts at %.6f,%.6f,%.6f", drive.scans.size(),
                          words.drive.speed, words.out.c_str(), start.x, start.y, start.theta));
}

/// One of some words.
template <std::size_t Count>
void add_choice(CLI::App& verb, const std::string& name, std::string& word,
                const std::array<std::string, Count>& choices, const std::string& meaning) {
  verb.add_option(name, word, meaning)
      ->capture_default_str()
      ->type_name("NAME")
      ->check(CLI::IsMember(std::vector<std::string>(choices.begin(), choices.end())));
}

}  // namespace

void add_simulate(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("simulate", "a log from a simulated robot, with the truth");
  const auto words = std::make_shared<SimulateWords>();
  verb->add_option("--out", words->out, "the log: .clf .log (CARMEN, with odometry), .csv (ranges)")
      ->required()
      ->type_name("LOG");
  verb->add_option("--world", words->world, "where: corridor, or a world's file (docs/worlds.md)")
      ->capture_default_str()
      ->type_name("NAME|FILE.yaml");
  verb->add_option(
          "--route", words->route,
          "which way: in the corridor reference (the paper's s-shaped path) or survey (all of it), else a name "
          "from the file; default: the world's first")
      ->type_name("NAME");
  verb->add_option("--obstacle", words->obstacle,
                   "one of the paper's obstacles, A1 to D3, in the corridor; default: none")
      ->type_name("A1..D3");
  verb->add_option("--people", words->crowd.people, "how many people more than the world has, seeded")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  add_choice(*verb, "--layout", words->layout, layout_names,
             "how they move about the route: crossing it, along it, in groups that stand, or a random-walk");
  add_choice(*verb, "--lidar", words->lidar, lidar_names,
             "hokuyo (a UTM-30LX with 1 cm of noise, all beams at once), exact-hokuyo (without noise), or real-hokuyo "
             "(noise that grows, systematic error, lost and mixed readings, a sweep of 25 ms)");
  add_choice(
      *verb, "--robot", words->robot, std::array<std::string, 2>{"differential", "omni"},
      "differential (looks where it goes, at constant speed) or omni (three wheels that slip, steered, slower in "
      "bends)");
  verb->add_option("--speed", words->drive.speed, "along the path [m/s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--seed", words->drive.seed, "of all noise, and of --people: the same seed gives the same bytes")
      ->capture_default_str();
  verb->add_option("--truth", words->truth, "true poses T_map_robot, a line a scan")->type_name("TUM");
  verb->add_option("--map-out", words->map_out,
                   "a map of the world without obstacles and people, doors as the map has them, with 1 cm noise")
      ->type_name("MAP");
  verb->add_option("--picture", words->picture, "the world, the robot's way, and where people walk")
      ->type_name("FILE.svg|.png");
  add_json(*verb, words->json);
  add_example(*verb, "slamicp simulate --out run.clf --obstacle A2 --truth truth.tum --map-out map.pcd");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
