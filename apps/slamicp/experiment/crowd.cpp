// SPDX-License-Identifier: Apache-2.0
// slamicp experiment crowd: what people about the robot change, by how many they are and how they move.
#include <algorithm>
#include <array>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/crowd_drive.hpp>
#include <slamicp/evaluation/error_statistics.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

constexpr std::array<CrowdLayout, 4> layouts = {CrowdLayout::crossing, CrowdLayout::along, CrowdLayout::groups,
                                                CrowdLayout::random_walk};

/// A drive among so many people.
struct Crowd {
  CrowdLayout layout;
  int people;
  std::vector<CrowdSample> samples;  // none: they found no room
};

double mean_of(const std::vector<CrowdSample>& samples, double (*value)(const CrowdSample&)) {
  double sum = 0.0;
  for (const CrowdSample& sample : samples) sum += value(sample);
  return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
}

double outliers_of(const CrowdSample& sample) { return static_cast<double>(sample.outliers); }
double awareness_of(const CrowdSample& sample) { return sample.awareness; }
double doubted(const CrowdSample& sample) { return is_doubted(sample.state) ? 1.0 : 0.0; }
double stop_of(const CrowdSample& sample) { return sample.decision == Decision::stop ? 1.0 : 0.0; }
double moving_of(const CrowdSample& sample) { return static_cast<double>(sample.moving); }

ErrorStatistics errors_of(const Crowd& crowd) {
  std::vector<double> errors;
  for (const CrowdSample& sample : crowd.samples) errors.push_back(sample.error);
  return statistics_of(std::move(errors));
}

std::ptrdiff_t false_stops(const Crowd& crowd) {
  return std::count_if(crowd.samples.begin(), crowd.samples.end(),
                       [](const CrowdSample& sample) { return sample.false_stop; });
}

Colour shade(std::size_t which, std::size_t count) {
  const double share = count > 1 ? static_cast<double>(which) / static_cast<double>(count - 1) : 1.0;
  const auto mix = [&](int from, int to) { return static_cast<std::uint8_t>(std::lround(from + share * (to - from))); };
  return {mix(58, 214), mix(110, 39), mix(165, 40)};
}

Chart draw(const std::vector<Crowd>& crowds, CrowdLayout layout, double (*value)(const CrowdSample&),
           const std::string& title, const std::string& label) {
  ChartOptions options;
  options.title = title;
  options.x_label = "time [s]";
  options.y_label = label;
  Chart chart(options);
  std::vector<const Crowd*> shown;
  for (const Crowd& crowd : crowds)
    if (crowd.layout == layout && !crowd.samples.empty()) shown.push_back(&crowd);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    PointCloud2 line;
    for (const CrowdSample& sample : shown[k]->samples) line.emplace_back(sample.stamp, value(sample));
    chart.line(line, shade(k, shown.size()), 1.2, format("%d people", shown[k]->people));
  }
  return chart;
}

struct Correlations {
  double people_outliers = 0.0;
  double outliers_awareness = 0.0;
  double awareness_error = 0.0;
};

/// People against mean outliers by drives; the other two by single scans of all drives.
Correlations correlate(const std::vector<Crowd>& crowds) {
  std::vector<double> people, mean_outliers, outliers, awareness, error;
  for (const Crowd& crowd : crowds) {
    if (crowd.samples.empty()) continue;
    people.push_back(crowd.people);
    mean_outliers.push_back(mean_of(crowd.samples, outliers_of));
    for (const CrowdSample& sample : crowd.samples) {
      outliers.push_back(outliers_of(sample));
      awareness.push_back(sample.awareness);
      error.push_back(sample.error);
    }
  }
  return {correlation(people, mean_outliers), correlation(outliers, awareness), correlation(awareness, error)};
}

std::vector<std::string> row_of(const Crowd& crowd) {
  if (crowd.samples.empty()) return {to_string(crowd.layout), format("%d", crowd.people), "no room"};
  const ErrorStatistics errors = errors_of(crowd);
  return {to_string(crowd.layout),
          format("%d", crowd.people),
          format("%.0f", mean_of(crowd.samples, outliers_of)),
          format("%.3f", mean_of(crowd.samples, awareness_of)),
          format("%.1f", 1e3 * errors.mean),
          format("%.1f", 1e3 * errors.p95),
          format("%.1f", 1e3 * errors.max),
          format("%.1f %%", 100.0 * mean_of(crowd.samples, doubted)),
          format("%.1f", mean_of(crowd.samples, moving_of)),
          format("%.1f %%", 100.0 * mean_of(crowd.samples, stop_of)),
          format("%td", false_stops(crowd))};
}

Json json_of(const Crowd& crowd) {
  Json row{{"layout", to_string(crowd.layout)}, {"people", crowd.people}, {"room", !crowd.samples.empty()}};
  if (crowd.samples.empty()) return row;
  const ErrorStatistics errors = errors_of(crowd);
  row.update({{"scans", crowd.samples.size()},
              {"outliers", mean_of(crowd.samples, outliers_of)},
              {"awareness", mean_of(crowd.samples, awareness_of)},
              {"error_mean", errors.mean},
              {"error_p95", errors.p95},
              {"error_max", errors.max},
              {"doubted", mean_of(crowd.samples, doubted)},
              {"moving_tracks", mean_of(crowd.samples, moving_of)},
              {"stopped", mean_of(crowd.samples, stop_of)},
              {"false_stops", false_stops(crowd)}});
  return row;
}

std::string csv_of(const std::vector<Crowd>& crowds) {
  std::string csv = "layout,people,stamp,outliers,awareness,error_mm,moving,state,decision,false_stop\n";
  for (const Crowd& crowd : crowds)
    for (const CrowdSample& sample : crowd.samples)
      csv += format("%s,%d,%.3f,%zu,%.4f,%.2f,%zu,%s,%s,%d\n", to_string(crowd.layout), crowd.people, sample.stamp,
                    sample.outliers, sample.awareness, 1e3 * sample.error, sample.moving, to_string(sample.state),
                    to_string(sample.decision), sample.false_stop ? 1 : 0);
  return csv;
}

std::vector<Crowd> drive_all(const ExperimentSite& site, const ExperimentWords& words) {
  std::vector<Crowd> crowds;
  Progress progress("driving", layouts.size() * words.people.size());
  for (const CrowdLayout layout : layouts)
    for (const int people : words.people) {
      Crowd crowd{layout, people, {}};
      try {
        crowd.samples = crowd_drive(site, {.people = people, .layout = layout, .seed = words.seed});
      } catch (const Error& problem) {
        warn(format("%d people, %s: ", people, to_string(layout)) + problem.what());
      }
      crowds.push_back(std::move(crowd));
      progress.step();
    }
  return crowds;
}

}  // namespace

Json run_crowd(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk) {
  const std::vector<Crowd> crowds = drive_all(site, words);
  Page page("People about the robot");
  tell_what_is_simulated(page, site);
  page.paragraph(
      "The robot drives the reference path at 0.5 m/s, ten scans a second, with so many people, who move in four ways. "
      "They mind it as little as it minds them, so that every drive sees all of the path; the agent decides, but moves "
      "nothing. A stop is false where nobody is within 1 m of the next 2 m of the way.");
  std::vector<std::vector<std::string>> table{{"layout", "people", "outliers", "awareness", "error mm, mean", "p95",
                                               "max", "doubted", "moving tracks", "stopped", "false stops"}};
  Json rows = Json::array();
  for (const Crowd& crowd : crowds) {
    table.push_back(row_of(crowd));
    rows.push_back(json_of(crowd));
    if (!crowd.samples.empty())
      talk(format("%-12s %2d people: %4.0f outliers, awareness %.3f, error %.1f mm mean, %.1f mm max, %td false stops",
                  to_string(crowd.layout), crowd.people, mean_of(crowd.samples, outliers_of),
                  mean_of(crowd.samples, awareness_of), 1e3 * errors_of(crowd).mean, 1e3 * errors_of(crowd).max,
                  false_stops(crowd)));
  }
  page.heading("In numbers");
  page.table(table);
  const Correlations found = correlate(crowds);
  const std::string correlations = format(
      "correlation: people and mean outliers %.2f; outliers and awareness, scan by scan, %.2f; awareness and error "
      "%.2f",
      found.people_outliers, found.outliers_awareness, found.awareness_error);
  talk(correlations);
  page.paragraph(correlations + ".");
  for (const CrowdLayout layout : layouts) {
    page.heading(to_string(layout));
    const std::string name = std::string("crowd_") + to_string(layout);
    const Chart outliers = draw(crowds, layout, outliers_of, std::string("outliers, ") + to_string(layout), "outliers");
    folder.save(name + "_outliers", outliers);
    page.figure(outliers.svg(), "Outliers of each scan.");
    const Chart awareness =
        draw(crowds, layout, awareness_of, std::string("situational awareness, ") + to_string(layout), "awareness");
    folder.save(name + "_awareness", awareness);
    page.figure(awareness.svg(), "The share of the surroundings that the map explains.");
  }
  folder.save_text("crowd.csv", csv_of(crowds));
  folder.save_text("crowd.html", page.html());
  return {{"drives", rows},
          {"correlation_people_outliers", found.people_outliers},
          {"correlation_outliers_awareness", found.outliers_awareness},
          {"correlation_awareness_error", found.awareness_error}};
}

}  // namespace slamicp::command
