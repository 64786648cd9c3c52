// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/relation_error.hpp>

#include "evaluation/stamp_index.hpp"

namespace slamicp {
namespace {

struct Errors {
  std::vector<double> translations;
  std::vector<double> rotations_deg;

  void add(const Pose2& error) {
    translations.push_back(error.translation().norm());
    rotations_deg.push_back(std::abs(wrap_angle(error.theta)) * 180.0 / std::numbers::pi);
  }
  RelationErrorStatistics statistics() && {
    return {statistics_of(std::move(translations)), statistics_of(std::move(rotations_deg))};
  }
};

std::string sentence(const RelationErrorStatistics& errors, const char* which) {
  char text[160];
  std::snprintf(text, sizeof text, "%.4f +- %.4f m, %.3f +- %.3f deg over %zu %s", errors.translation.mean,
                errors.translation.standard_deviation, errors.rotation_deg.mean, errors.rotation_deg.standard_deviation,
                errors.translation.count, which);
  return text;
}

void check(std::span<const Relation> relations) {
  if (relations.empty()) throw Error("there is no relation", "relations", "give at least one");
  for (std::size_t i = 0; i < relations.size(); ++i)
    if (!std::isfinite(relations[i].stamp_a) || !std::isfinite(relations[i].stamp_b) || !relations[i].T_a_b.is_finite())
      throw Error("a number is not finite", "relation " + std::to_string(i) + " counted from 0", "leave it out");
}

}  // namespace

std::string RelationErrorOptions::problem() const {
  if (!(stamp_tolerance >= 0.0)) return "stamp_tolerance must be 0 s or more";
  if (!(long_span >= 0.0)) return "long_span must be 0 s or more";
  return {};
}

std::string RelationError::brief() const {
  return sentence(all, "relations") + "; " + sentence(long_spans, "long ones") + "; " + std::to_string(not_found) +
         " relations not found";
}

RelationError relation_error(const Trajectory& estimate, std::span<const Relation> relations,
                             const RelationErrorOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "RelationErrorOptions");
  check_trajectory(estimate, "estimated trajectory");
  check(relations);

  const StampIndex index(estimate);
  Errors all;
  Errors long_spans;
  RelationError result;
  for (const Relation& relation : relations) {
    const auto a = index.find(relation.stamp_a, options.stamp_tolerance);
    const auto b = index.find(relation.stamp_b, options.stamp_tolerance);
    if (!a || !b) {
      ++result.not_found;
      continue;
    }
    const Pose2 error = relation.T_a_b.inverse() * (estimate[*a].pose.inverse() * estimate[*b].pose);
    all.add(error);
    if (std::abs(relation.stamp_b - relation.stamp_a) > options.long_span) long_spans.add(error);
  }
  if (all.translations.empty())
    throw Error("no relation has both its stamps in the trajectory",
                "first relation: " + std::to_string(relations.front().stamp_a) + " to " +
                    std::to_string(relations.front().stamp_b) + " s",
                "score the trajectory of the same log, with the stamps that it has there (CARMEN: ipc_timestamp)");
  result.all = std::move(all).statistics();
  result.long_spans = std::move(long_spans).statistics();
  return result;
}

}  // namespace slamicp
