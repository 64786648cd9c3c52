// SPDX-License-Identifier: Apache-2.0
// slamicp evaluate: how wrong a trajectory is.
#include <map>
#include <memory>
#include <optional>

#include <slamicp/evaluation/relation_error.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/relations_file.hpp>
#include <slamicp/io/trajectory_file.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct EvaluateWords {
  std::string trajectory, truth, relations, json, align = "none";
  double distance = 1.0;
};

Json error_json(const TrajectoryError& error) {
  return {{"translation", to_json(error.translation)},
          {"rotation", to_json(error.rotation)},
          {"unmatched", error.unmatched}};
}
Json error_json(const RelationErrorStatistics& errors) {
  return {{"translation", to_json(errors.translation)}, {"rotation_deg", to_json(errors.rotation_deg)}};
}

/// Errors of the motion over each stretch of the path; nothing where the path is shorter.
std::optional<TrajectoryError> over_stretches(const EvaluateWords& words, const Trajectory& estimate,
                                              const Trajectory& truth) {
  if (path_length(truth) < words.distance) return std::nullopt;
  return relative_error(estimate, truth, words.distance);
}

void against_truth(const EvaluateWords& words) {
  static const std::map<std::string, Alignment> alignments{
      {"none", Alignment::none}, {"first", Alignment::first}, {"se2", Alignment::se2}};
  TrajectoryErrorOptions options;
  options.alignment = alignments.at(words.align);
  const Trajectory estimate = load_trajectory(file_named(words.trajectory));
  const Trajectory truth = load_trajectory(file_named(words.truth));
  const TrajectoryError absolute = absolute_error(estimate, truth, options);
  const std::optional<TrajectoryError> relative = over_stretches(words, estimate, truth);
  Json summary{{"verb", "evaluate"},
               {"trajectory", words.trajectory},
               {"truth", words.truth},
               {"align", words.align},
               {"T_truth_estimate", to_json(absolute.T_truth_estimate)},
               {"absolute", error_json(absolute)}};
  if (relative) {
    summary["relative"] = error_json(*relative);
    summary["relative"]["distance"] = words.distance;
    summary["relative"]["translation_per_metre"] = relative->translation.mean / words.distance;
    summary["relative"]["rotation_per_metre"] = relative->rotation.mean / words.distance;
  }
  write_json(words.json, summary);
  const Talk talk(words.json);
  talk("absolute error, aligned " + words.align + ": " + absolute.brief());
  if (relative)
    talk(format("relative error over %g m (%.2f %%, %.3f deg/m): ", words.distance,
                100.0 * relative->translation.mean / words.distance,
                relative->rotation.mean * deg_per_rad / words.distance) +
         relative->brief());
  else
    talk(format("no relative error: the true path is shorter than %g m", words.distance));
}

void against_relations(const EvaluateWords& words) {
  const RelationError error =
      relation_error(load_trajectory(file_named(words.trajectory)), load_relations(file_named(words.relations)));
  write_json(words.json, {{"verb", "evaluate"},
                          {"trajectory", words.trajectory},
                          {"relations", words.relations},
                          {"all", error_json(error.all)},
                          {"over_60_s", error_json(error.long_spans)},
                          {"not_found", error.not_found}});
  Talk{words.json}("relation error: " + error.brief());
}

}  // namespace

void add_evaluate(CLI::App& program) {
  CLI::App* verb =
      program.add_subcommand("evaluate", "errors of a trajectory against the truth or a benchmark's relations");
  const auto words = std::make_shared<EvaluateWords>();
  verb->add_option("TRAJECTORY", words->trajectory, "TUM file: stamp x y z qx qy qz qw")->required();
  CLI::Option* truth =
      verb->add_option("--truth", words->truth, "true poses: mean, RMSE, p95 and largest error")->type_name("TUM");
  verb->add_option("--align", words->align,
                   "move the trajectory onto the truth first: none, first pose, best fit (se2)")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "first", "se2"}))
      ->needs(truth);
  verb->add_option("--relative-distance", words->distance, "stretches of the path whose relative error is told [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber)
      ->needs(truth);
  CLI::Option* relations = verb->add_option("--relations", words->relations,
                                            "true relative poses: the SLAM benchmark's score (Kuemmerle 2009)")
                               ->type_name("FILE");
  truth->excludes(relations);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp evaluate run.tum --relations intel.relations");
  verb->callback([words] {
    if (!words->truth.empty())
      against_truth(*words);
    else if (!words->relations.empty())
      against_relations(*words);
    else
      throw CLI::RequiredError("--truth or --relations");
  });
}

}  // namespace slamicp::command
