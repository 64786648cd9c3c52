// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/geometry/angle.hpp>

#include "evaluation/stamp_index.hpp"

namespace slamicp {
namespace {

struct Pair {
  Pose2 estimate;
  Pose2 truth;
};

struct Association {
  std::vector<Pair> pairs;  // in the estimate's order
  std::size_t unmatched = 0;
};

std::string span_of(const Trajectory& trajectory) {
  double first = trajectory.front().stamp;
  double last = first;
  for (const StampedPose& pose : trajectory) {
    first = std::min(first, pose.stamp);
    last = std::max(last, pose.stamp);
  }
  char text[80];
  std::snprintf(text, sizeof text, "%.6f to %.6f s", first, last);
  return text;
}

Association associate(const Trajectory& estimate, const Trajectory& truth, const TrajectoryErrorOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "TrajectoryErrorOptions");
  check_trajectory(estimate, "estimated trajectory");
  check_trajectory(truth, "true trajectory");

  const StampIndex index(truth);
  const std::vector<std::size_t> occurrences = StampIndex(estimate).occurrences();
  Association association;
  association.pairs.reserve(estimate.size());
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    if (const auto found = index.find(estimate[i].stamp, options.stamp_tolerance, occurrences[i]))
      association.pairs.push_back({estimate[i].pose, truth[*found].pose});
    else
      ++association.unmatched;
  }
  if (association.pairs.empty())
    throw Error("no stamp of the estimate is near one of the truth",
                "estimate " + span_of(estimate) + ", truth " + span_of(truth),
                "use stamps of the same clock, or raise the stamp tolerance");
  return association;
}

// In the plane the least-squares rotation has a closed form: the angle of the summed cross and dot products.
Pose2 least_squares(const std::vector<Pair>& pairs) noexcept {
  Point2 centre_of_estimate = Point2::Zero();
  Point2 centre_of_truth = Point2::Zero();
  for (const Pair& pair : pairs) {
    centre_of_estimate += pair.estimate.translation();
    centre_of_truth += pair.truth.translation();
  }
  centre_of_estimate /= static_cast<double>(pairs.size());
  centre_of_truth /= static_cast<double>(pairs.size());

  double cosine = 0.0;
  double sine = 0.0;
  for (const Pair& pair : pairs) {
    const Point2 from = pair.estimate.translation() - centre_of_estimate;
    const Point2 to = pair.truth.translation() - centre_of_truth;
    cosine += from.dot(to);
    sine += cross(from, to);
  }
  const Pose2 turn{0.0, 0.0, std::atan2(sine, cosine)};
  const Point2 shift = centre_of_truth - turn * centre_of_estimate;
  return {shift.x(), shift.y(), wrap_angle(turn.theta)};
}

Pose2 alignment_of(const std::vector<Pair>& pairs, Alignment alignment) noexcept {
  switch (alignment) {
    case Alignment::first:
      return pairs.front().truth * pairs.front().estimate.inverse();
    case Alignment::se2:
      return least_squares(pairs);
    case Alignment::none:
      break;
  }
  return {};
}

class Collector {
 public:
  void add(const Pose2& error) {
    translations_.push_back(error.translation().norm());
    rotations_.push_back(std::abs(wrap_angle(error.theta)));
  }
  bool empty() const noexcept { return translations_.empty(); }
  TrajectoryError result(std::size_t unmatched, const Pose2& T_truth_estimate) && {
    return {statistics_of(std::move(translations_)), statistics_of(std::move(rotations_)), unmatched, T_truth_estimate};
  }

 private:
  std::vector<double> translations_;
  std::vector<double> rotations_;
};

}  // namespace

std::string TrajectoryErrorOptions::problem() const {
  if (!(stamp_tolerance >= 0.0)) return "stamp_tolerance must be 0 s or more";
  return {};
}

std::string TrajectoryError::brief() const {
  constexpr double to_mm = 1e3;
  char text[240];
  std::snprintf(text, sizeof text,
                "translation mean %.1f, rmse %.1f, p95 %.1f, max %.1f mm; rotation mean %.3f, rmse %.3f, p95 %.3f, "
                "max %.3f deg; %zu errors, %zu poses unmatched",
                to_mm * translation.mean, to_mm * translation.rmse, to_mm * translation.p95, to_mm * translation.max,
                deg_per_rad * rotation.mean, deg_per_rad * rotation.rmse, deg_per_rad * rotation.p95,
                deg_per_rad * rotation.max, translation.count, unmatched);
  return text;
}

TrajectoryError absolute_error(const Trajectory& estimate, const Trajectory& truth,
                               const TrajectoryErrorOptions& options) {
  const Association association = associate(estimate, truth, options);
  const Pose2 T_truth_estimate = alignment_of(association.pairs, options.alignment);
  Collector errors;
  for (const Pair& pair : association.pairs) errors.add(pair.truth.inverse() * T_truth_estimate * pair.estimate);
  return std::move(errors).result(association.unmatched, T_truth_estimate);
}

TrajectoryError relative_error(const Trajectory& estimate, const Trajectory& truth, double distance,
                               const TrajectoryErrorOptions& options) {
  if (!(distance > 0.0)) throw Error("the distance must be above 0 m", "relative_error", "try 1.0");
  const Association association = associate(estimate, truth, options);
  const std::vector<Pair>& pairs = association.pairs;
  std::vector<double> travelled = {0.0};
  for (std::size_t i = 1; i < pairs.size(); ++i)
    travelled.push_back(travelled.back() + (pairs[i].truth.translation() - pairs[i - 1].truth.translation()).norm());

  Collector errors;
  // The path length is a sum: a stretch that misses the distance by a rounding error is long enough.
  const double long_enough = distance * (1.0 - 1e-9);
  std::size_t end = 0;
  for (std::size_t start = 0; start < pairs.size(); ++start) {
    while (end < pairs.size() && travelled[end] - travelled[start] < long_enough) ++end;
    if (end == pairs.size()) break;
    const Pose2 true_motion = pairs[start].truth.inverse() * pairs[end].truth;
    const Pose2 estimated_motion = pairs[start].estimate.inverse() * pairs[end].estimate;
    errors.add(true_motion.inverse() * estimated_motion);
  }
  if (errors.empty())
    throw Error("the true path is " + std::to_string(travelled.back()) + " m, shorter than the distance",
                "relative_error", "ask for a distance below it");
  return std::move(errors).result(association.unmatched, {});
}

}  // namespace slamicp
