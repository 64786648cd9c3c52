// SPDX-License-Identifier: Apache-2.0
// slamicp-bench: all contenders on the scans of a file.
#include <cstdlib>

#include <slamicp/io/output_file.hpp>

#include "commands.hpp"
#include "machine.hpp"
#include "peers.hpp"
#include "race.hpp"
#include "report.hpp"

namespace slamicp::bench {
namespace {

struct Words {
  SceneFiles files;
  std::string world = "box";
  std::size_t scans = 0;
  RaceOptions race;
  std::vector<std::string> only;
  std::vector<std::string> peers;
  std::string json;
};

std::filesystem::path data_folder() {
  const char* folder = std::getenv("SLAMICP_DATA_DIR");
  return folder != nullptr && *folder != '\0' ? folder : SLAMICP_DATA_DIR;
}

/// The files that were not named are those of the corridor.
SceneFiles with_defaults(SceneFiles files, const std::string& world) {
  const std::filesystem::path folder = data_folder() / "corridor";
  if (files.map.empty()) files.map = folder / "map.csv";
  if (files.ranges.empty()) files.ranges = folder / ("ranges_" + world + ".csv");
  if (files.poses.empty()) files.poses = folder / ("poses_" + world + ".csv");
  return files;
}

Json describe(const Scene& scene, const SceneFiles& files) {
  return {{"name", scene.name},
          {"map", files.map.string()},
          {"ranges", files.ranges.string()},
          {"poses", files.poses.string()},
          {"fov_deg", files.fov_deg},
          {"map_points", scene.map->size()},
          {"scans", scene.trials.size()},
          {"scan_points", mean_scan_points(scene)}};
}

void run(const Words& words) {
  Field field = chosen(whole_field(), words.only);
  const SceneFiles files = with_defaults(words.files, words.world);
  const Scene scene = load_scene(files, words.scans);
  std::vector<Peers> peers;
  for (const std::string& file : words.peers) peers.push_back(load_peers(file, scene));

  std::vector<Row> rows = race(scene, field.contenders, words.race);
  for (const Peers& other : peers) {
    rows.insert(rows.end(), other.rows.begin(), other.rows.end());
    field.missing.insert(field.missing.end(), other.missing.begin(), other.missing.end());
  }

  const Machine machine = this_machine();
  std::FILE* const out = words.json == "-" ? stderr : stdout;
  std::fprintf(out,
               "%s: %zu scans of %.0f points, a map of %zu; gate and outlier distance %.1f m; one thread, %d rounds in "
               "turns\n%s\n\n",
               scene.name.c_str(), scene.trials.size(), mean_scan_points(scene), scene.map->size(), gate,
               words.race.rounds, brief(machine).c_str());
  print_rows(rows, out);
  print_missing(field.missing, out);
  if (words.json.empty()) return;
  const Json results = {{"scene", describe(scene, files)},
                        {"machine", to_json(machine)},
                        {"rounds", words.race.rounds},
                        {"block", words.race.block},
                        {"gate", gate},
                        {"reference", reference_name},
                        {"contenders", to_json(rows)},
                        {"missing", to_json(field.missing)}};
  write_file(words.json, results.dump(2) + "\n");
}

}  // namespace

void add_localization(CLI::App& program) {
  const auto words = std::make_shared<Words>();
  program.add_option("--map", words->files.map, "the map, x,y a line; default: the corridor of SLAMICP_DATA_DIR")
      ->type_name("CSV");
  program.add_option("--ranges", words->files.ranges, "the scans, ranges [m], a scan a line")->type_name("CSV");
  program.add_option("--poses", words->files.poses, "truth and guess of each scan: x,y,theta,x,y,theta [m, rad]")
      ->type_name("CSV");
  program.add_option("--world", words->world, "which scans of the corridor: none, or box (a box that the map lacks)")
      ->capture_default_str();
  program.add_option("--fov-deg", words->files.fov_deg, "field of view, first beam to last [deg]")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 360.0));
  program.add_option("--scans", words->scans, "take so many scans, evenly spread; 0: all")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  program.add_option("--rounds", words->race.rounds, "times through all scans")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  program.add_option("--block", words->race.block, "scans in a row before the next contender's turn; 1: cold caches")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  program.add_option("--only", words->only, "names of contenders, or how they begin: ours,original,improved,pcl,mrpt")
      ->delimiter(',')
      ->type_name("NAME,...");
  program.add_option("--peers", words->peers, "add what bench/peers.py measured")->type_name("JSON");
  program.add_option("--json", words->json, "write all results; '-' is stdout")->type_name("FILE");
  program.callback([&program, words] {
    if (program.get_subcommands().empty()) run(*words);
  });
}

}  // namespace slamicp::bench
