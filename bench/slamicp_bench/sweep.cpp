// SPDX-License-Identifier: Apache-2.0
// slamicp-bench sweep: how times and errors change with the map, the scan and the guess, in made-up buildings.
#include <algorithm>
#include <memory>
#include <stdexcept>

#include <slamicp/io/output_file.hpp>

#include "commands.hpp"
#include "machine.hpp"
#include "race.hpp"
#include "report.hpp"
#include "sweeps.hpp"
#include "throughput.hpp"

namespace slamicp::bench {
namespace {

using measure::text;

struct Words {
  std::string name;
  double max_map_points = 1e7;
  std::size_t scans = 40;
  std::uint64_t seed = 1;
  RaceOptions race{.rounds = 3, .block = 10, .budget_s = 20.0};
  std::vector<std::string> only{"ours_outliers", "original", "improved"};
  std::string json, csv;
};

/// Brute force is left out where a scan of it would take seconds.
bool has_time_for(const Contender& contender, const Scene& scene) {
  constexpr double most_pairs = 2e9;
  return !contender.name.starts_with("original") ||
         mean_scan_points(scene) * static_cast<double>(scene.map->size()) < most_pairs;
}

void print_scene(const std::string& label, const Scene& scene, std::FILE* out) {
  std::fprintf(out, "%s: %s, a map of %zu points, %zu scans of %.0f points\n", label.c_str(), scene.name.c_str(),
               scene.map->size(), scene.trials.size(), mean_scan_points(scene));
}

Json describe(const Setting& setting, const Scene& scene, Json rows) {
  return {{"value", setting.value},
          {"label", setting.label},
          {"layout", to_string(setting.recipe.layout)},
          {"map_points", scene.map->size()},
          {"beams", setting.recipe.beams},
          {"scan_points", mean_scan_points(scene)},
          {"outlier_share", setting.recipe.outlier_share},
          {"guess_sigma", setting.recipe.guess_sigma},
          {"guess_turn_sigma_deg", setting.recipe.guess_turn_sigma_deg},
          {"contenders", std::move(rows)}};
}

/// A scene for each setting, a race in each.
Json measure_times(const Sweep& sweep, std::span<const Contender> field, const Words& words, std::FILE* out) {
  Json settings = Json::array();
  for (const Setting& setting : sweep.settings) {
    const Scene scene = make_scene(setting.recipe);
    std::vector<Contender> contenders(field.begin(), field.end());
    std::erase_if(contenders, [&](const Contender& contender) { return !has_time_for(contender, scene); });
    const std::vector<Row> rows = race(scene, contenders, words.race);
    print_scene(setting.label, scene, out);
    print_rows(rows, out);
    std::fprintf(out, "\n");
    std::fflush(out);
    settings.push_back(describe(setting, scene, to_json(rows)));
  }
  return settings;
}

/// One scene and one race, and then the scans a second of each number of threads, in turns.
Json measure_throughput(const Sweep& sweep, std::span<const Contender> field, const Words& words, std::FILE* out) {
  const Scene scene = make_scene(sweep.settings.front().recipe);
  print_scene(sweep.name, scene, out);
  const std::vector<Row> rows = race(scene, field, words.race);
  print_rows(rows, out);
  std::vector<int> threads;
  for (const Setting& setting : sweep.settings) threads.push_back(setting.threads);
  const auto counts = scans_per_second(scene, field, threads, words.race.rounds);

  Json settings = Json::array();
  AlignedTable table({"contender", "threads", "scans a second", ""});
  for (std::size_t s = 0; s < sweep.settings.size(); ++s) {
    Json told = to_json(rows);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      told[k]["scans_per_second"] = counts[s][k];
      table.add({rows[k].name, sweep.settings[s].label, text("%.0f", counts[s][k]), ""});
    }
    settings.push_back(describe(sweep.settings[s], scene, told));
  }
  std::fprintf(out, "\n");
  table.print(out);
  return settings;
}

std::string csv_of(const Json& results) {
  std::string lines =
      "sweep,value,label,map_points,contender,median_us,p99_us,ratio_to_ours,prepare_ms,iterations,error_mm_mean,"
      "error_mm_p95,failures,scans,outliers_mean,outlier_agreement,scans_per_second\n";
  for (const Json& setting : results["settings"])
    for (const Json& row : setting["contenders"]) {
      const auto cell = [](const Json& value) {
        return value.is_null() ? std::string() : value.is_string() ? value.get<std::string>() : value.dump();
      };
      const Json& error = row["error_mm"];
      const Json throughput = row.value("scans_per_second", Json(nullptr));
      std::string separator;
      for (const Json& value :
           {results["sweep"], setting["value"], setting["label"], setting["map_points"], row["name"], row["median_us"],
            row["p99_us"], row["ratio_to_ours"], row["prepare_ms"], row["iterations"], error["mean"], error["p95"],
            row["failures"], row["scans"], row["outliers_mean"], row["outlier_agreement"], throughput}) {
        lines += separator + cell(value);
        separator = ",";
      }
      lines += '\n';
    }
  return lines;
}

void run(const Words& words) {
  Sweep sweep = sweep_named(words.name);
  std::erase_if(sweep.settings,
                [&](const Setting& setting) { return setting.recipe.map_points > words.max_map_points; });
  for (Setting& setting : sweep.settings) {
    setting.recipe.seed = words.seed;
    setting.recipe.scans = words.scans;
  }
  if (sweep.settings.empty()) throw std::invalid_argument("--max-map-points leaves out every setting: give more");

  const Field field = chosen(whole_field(), words.only);
  const Machine machine = this_machine();
  std::FILE* const out = words.json == "-" || words.csv == "-" ? stderr : stdout;
  std::fprintf(out, "sweep of %s, seed %llu; gate and outlier distance %.1f m\n%s\n\n", words.name.c_str(),
               static_cast<unsigned long long>(words.seed), gate, brief(machine).c_str());
  const auto measure_all = sweep.counts_scans ? measure_throughput : measure_times;
  const Json results = {{"sweep", sweep.name},
                        {"axis", sweep.axis},
                        {"unit", sweep.unit},
                        {"seed", words.seed},
                        {"reference", reference_name},
                        {"machine", to_json(machine)},
                        {"settings", measure_all(sweep, field.contenders, words, out)},
                        {"missing", to_json(field.missing)}};
  print_missing(field.missing, out);
  if (!words.json.empty()) write_file(words.json, results.dump(2) + "\n");
  if (!words.csv.empty()) write_file(words.csv, csv_of(results));
}

}  // namespace

void add_sweep(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("sweep", "change one thing of a made-up building, seeded");
  const auto words = std::make_shared<Words>();
  verb->add_option("NAME", words->name, "what to change")->required()->check(CLI::IsMember(sweep_names()));
  verb->add_option("--max-map-points", words->max_map_points, "leave out larger maps")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--scans", words->scans, "scans of each setting")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  verb->add_option("--rounds", words->race.rounds, "times through all scans")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  verb->add_option("--budget-s", words->race.budget_s, "time that a contender may use in a setting [s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--seed", words->seed, "another seed is another building")->capture_default_str();
  verb->add_option("--only", words->only, "names of contenders, or how they begin")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->capture_default_str();
  verb->add_option("--json", words->json, "write all results; '-' is stdout")->type_name("FILE");
  verb->add_option("--csv", words->csv, "write a line for each setting and contender; '-' is stdout")
      ->type_name("FILE");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::bench
