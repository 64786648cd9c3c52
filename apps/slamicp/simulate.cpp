// SPDX-License-Identifier: Apache-2.0
// slamicp simulate: a seeded run of the simulator.
#include <memory>

#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct SimulateWords {
  std::string out, world = "corridor", route = "reference", obstacle, truth, map_out, json;
  DriveOptions drive;
};

void run(const SimulateWords& words) {
  if (words.world != "corridor")
    throw Error("there is no world '" + words.world + "'", "--world", "the worlds are: corridor");
  const World empty = corridor_world();
  const World world = words.obstacle.empty() ? empty : corridor_world_with(words.obstacle);
  const SimulatedRun drive = simulate_drive(world, route(world, words.route).waypoints, words.drive);
  save_scan_log(words.out, drive.scans);
  if (!words.truth.empty()) save_trajectory(words.truth, drive.truth);
  std::size_t map_points = 0;
  if (!words.map_out.empty()) {
    Random random(words.drive.seed);
    const PointCloud2 map = sample_map(empty, random);  // what the map was before the obstacle came
    map_points = map.size();
    save_cloud(words.map_out, map);
  }
  write_json(words.json, {{"verb", "simulate"},
                          {"out", words.out},
                          {"world", words.world},
                          {"route", words.route},
                          {"obstacle", words.obstacle},
                          {"speed", words.drive.speed},
                          {"seed", words.drive.seed},
                          {"scans", drive.scans.size()},
                          {"map_points", map_points},
                          {"initial_pose", to_json(drive.truth.front().pose)}});
  const Pose2& start = drive.truth.front().pose;
  Talk{words.json}(format("%zu scans at %.2f m/s -> %s; the robot starts at %.6f,%.6f,%.6f", drive.scans.size(),
                          words.drive.speed, words.out.c_str(), start.x, start.y, start.theta));
}

}  // namespace

void add_simulate(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("simulate", "a log from a simulated robot, with the truth");
  const auto words = std::make_shared<SimulateWords>();
  verb->add_option("--out", words->out, "the log: .clf .log (CARMEN, with odometry), .csv (ranges)")
      ->required()
      ->type_name("LOG");
  verb->add_option("--world", words->world, "where: corridor")->capture_default_str()->type_name("NAME");
  verb->add_option("--route", words->route,
                   "which way: reference (the paper's s-shaped path) or survey (all of the world)")
      ->capture_default_str()
      ->type_name("NAME");
  verb->add_option("--obstacle", words->obstacle, "one of the paper's obstacles, A1 to D3; default: none")
      ->type_name("A1..D3");
  verb->add_option("--speed", words->drive.speed, "along the path [m/s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--seed", words->drive.seed, "of all noise: the same seed gives the same bytes")
      ->capture_default_str();
  verb->add_option("--truth", words->truth, "true poses T_map_robot, a line a scan")->type_name("TUM");
  verb->add_option("--map-out", words->map_out, "a map of the world without the obstacle, with 1 cm noise")
      ->type_name("MAP");
  add_json(*verb, words->json);
  add_example(*verb, "slamicp simulate --out run.clf --obstacle A2 --truth truth.tum --map-out map.pcd");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
