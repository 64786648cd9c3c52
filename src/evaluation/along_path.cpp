// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/along_path.hpp>

namespace slamicp {
namespace {

/// Squares of deviations from a mean, divided by one less than their number: the variance of what they are drawn from.
double variance(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / static_cast<double>(values.size() - 1);
}

std::size_t shortest(const std::vector<std::vector<double>>& curves) {
  std::size_t length = curves.empty() ? 0 : curves.front().size();
  for (const std::vector<double>& curve : curves) length = std::min(length, curve.size());
  return length;
}

std::vector<double> column(const std::vector<std::vector<double>>& curves, std::size_t place) {
  std::vector<double> values;
  values.reserve(curves.size());
  for (const std::vector<double>& curve : curves) values.push_back(curve[place]);
  return values;
}

}  // namespace

std::vector<double> along_path(const RecordedDrive& drive, const std::function<double(const DriveSample&)>& value,
                               double length, double step) {
  if (!(step > 0.0)) throw Error("the step is not above 0 m", "along_path", "give a length, such as 0.05");
  std::vector<double> curve;
  const auto& samples = drive.samples;
  std::size_t next = 0;  // the first sample that is not before the place
  for (std::size_t k = 0; static_cast<double>(k) * step <= length; ++k) {
    const double place = static_cast<double>(k) * step;
    while (next < samples.size() && samples[next].travelled < place) ++next;
    if (next == samples.size()) break;
    const bool before = next > 0 && place - samples[next - 1].travelled < samples[next].travelled - place;
    curve.push_back(value(samples[before ? next - 1 : next]));
  }
  return curve;
}

std::vector<double> mean_curve(const std::vector<std::vector<double>>& curves) {
  std::vector<double> mean(shortest(curves), 0.0);
  for (const std::vector<double>& curve : curves)
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += curve[k] / static_cast<double>(curves.size());
  return mean;
}

CurveSpread spread_of(const std::vector<std::vector<std::vector<double>>>& groups) {
  if (groups.empty()) throw Error("there are no curves", "spread_of", "give at least one group of one curve");
  std::vector<std::vector<double>> means;
  for (const auto& group : groups) {
    if (group.empty()) throw Error("a group has no curves", "spread_of", "leave it out");
    means.push_back(mean_curve(group));
  }
  CurveSpread spread;
  double places = 0.0;
  for (std::size_t k = 0; k < shortest(means); ++k) {
    const double between = variance(column(means, k));
    double within = 0.0;
    for (const auto& group : groups) within += variance(column(group, k)) / static_cast<double>(groups.size());
    if (!std::isfinite(between) || !std::isfinite(within)) continue;
    spread.between_groups += between;
    spread.within_groups += within;
    ++places;
  }
  if (places == 0.0) return {};
  return {std::sqrt(spread.between_groups / places), std::sqrt(spread.within_groups / places)};
}

}  // namespace slamicp
