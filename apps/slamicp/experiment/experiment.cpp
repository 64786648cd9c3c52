// SPDX-License-Identifier: Apache-2.0
// slamicp experiment: the paper's experiments, on the simulated robot.
#include "experiment.hpp"

#include <memory>

#include <slamicp/error.hpp>
#include <slamicp/simulation/corridor_world.hpp>

#include "../verbs.hpp"
#include "../words.hpp"

namespace slamicp::command {
namespace {

struct Experiment {
  const char* name;
  const char* what;
  Json (*run)(const ExperimentWords&, const ExperimentSite&, const Folder&, const Talk&);
};

constexpr Experiment experiments[] = {
    {"table1", "Table 1: both agents with twelve obstacles", &run_table1},
    {"velocity", "Figures 11, 12, 14, 15: outliers and inlier distance at several speeds", &run_velocity},
    {"snapshots", "Figures 10, 13: inliers and outliers from three places", &run_snapshots},
    {"maps", "Figures 2 to 8: scans, site, obstacles, maps", &run_maps},
    {"reconstruction", "Figure 16: the shapes of obstacles", &run_reconstruction},
    {"crowd", "people about the robot: outliers, awareness, accuracy, false stops", &run_crowd}};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Experiment& experiment : experiments) all.emplace_back(experiment.name);
  return all;
}

std::string name_help() {
  std::string text = "which one:";
  for (const Experiment& experiment : experiments)
    text += std::string(" ") + experiment.name + " (" + experiment.what + ");";
  text.back() = '.';
  return text;
}

void run(const ExperimentWords& words) {
  for (const std::string& obstacle : words.obstacles) corridor_obstacle(obstacle);  // throws for a name of none
  const Folder folder(words.out);
  const Talk talk(words.json);
  const ExperimentSite site = explore_site(words.seed);
  talk(format("map       %zu points of an exploration of %zu scans (the paper: 10402); path error %.0f mm mean",
              site.map->size(), site.survey_scans, 1e3 * site.survey_error.mean));
  for (const Experiment& experiment : experiments) {
    if (words.name != experiment.name) continue;
    Json summary{{"verb", "experiment"}, {"name", words.name}, {"seed", words.seed}, {"map_points", site.map->size()}};
    summary.update(experiment.run(words, site, folder, talk));
    write_json(words.json, summary);
  }
  std::string pictures;
  for (const char* ending : picture_endings()) pictures += std::string(pictures.empty() ? "" : " and ") + ending;
  talk("written   " + words.out + "/" + words.name + ".{html,csv}, pictures " + pictures);
}

}  // namespace

void add_experiment(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("experiment", "repeat an experiment of the paper on the simulated robot");
  const auto words = std::make_shared<ExperimentWords>();
  verb->add_option("NAME", words->name, name_help())->required()->check(CLI::IsMember(names()));
  verb->add_option("--out", words->out, "folder for the report (HTML), tables (CSV) and pictures (SVG, PNG)")
      ->required()
      ->type_name("DIR");
  verb->add_option("--seed", words->seed, "of all noise: the same seed gives the same files, times apart")
      ->capture_default_str();
  verb->add_option("--runs", words->runs, "drives of each kind, each with its own noise (table1, velocity)")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--speeds", words->speeds, "along the path (velocity) [m/s]")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--obstacles", words->obstacles,
                   "which ones, A1 to D3, besides none; default: those of the paper's experiment")
      ->delimiter(',')
      ->type_name("A1..D3");
  verb->add_option("--people", words->people, "how many in each drive (crowd)")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  verb->add_option("--every", words->every,
                   "of so many scans show both agents one (table1): the original one compares by brute force")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_flag_callback(
      "--no-times", [words] { words->times = false; }, "leave out what differs from machine to machine");
  add_json(*verb, words->json);
  add_example(*verb, "slamicp experiment table1 --out table1");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
