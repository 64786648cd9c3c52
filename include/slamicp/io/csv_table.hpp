// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

#include <slamicp/io/output_file.hpp>

namespace slamicp {

/// One outlier of one scan.
struct OutlierRow {
  std::size_t scan = 0;                                       ///< counted from 0
  double stamp = 0.0;                                         ///< [s]
  int beam = 0;                                               ///< counted from 0
  double x = 0.0;                                             ///< in the map [m]
  double y = 0.0;                                             ///< in the map [m]
  double distance = std::numeric_limits<double>::infinity();  ///< to the nearest map point [m]; infinite: none in reach
  std::string kind = "unknown";                               ///< obstacle, gone, unmapped, unknown
};

/// How one scan was matched.
struct MetricsRow {
  std::size_t scan = 0;  ///< counted from 0
  double stamp = 0.0;    ///< [s]
  double x = 0.0;        ///< robot in the map [m]
  double y = 0.0;        ///< [m]
  double theta = 0.0;    ///< [rad]
  std::string stop;      ///< converged, max_iterations, degenerate, too_few_points, no_overlap
  int iterations = 0;
  std::size_t points = 0;             ///< of the scan
  std::size_t inliers = 0;            ///< closer to the map than the correspondence distance
  std::size_t outliers = 0;           ///< at least the outlier distance from the map
  double mean_inlier_distance = 0.0;  ///< [m]; NaN without inliers
  double time_us = 0.0;               ///< what the match took [us]
  std::string state = "tracking";     ///< tracking, degenerate, suspect, lost
  double probability = 1.0;           ///< that the pose is right
  double var_x = 0.0;                 ///< of the pose in the map [m^2]; NaN where not known
  double var_y = 0.0;                 ///< [m^2]
  double var_theta = 0.0;             ///< [rad^2]
  double blind_deg = 0.0;  ///< the direction in the map that the scan does not hold, in [0, 180); NaN: there is none
};

/// One obstacle as seen in one scan.
struct ObstacleRow {
  std::size_t scan = 0;  ///< counted from 0
  double stamp = 0.0;    ///< [s]
  int id = 0;
  std::string kind;
  double x = 0.0;        ///< centre in the map [m]
  double y = 0.0;        ///< [m]
  double width = 0.0;    ///< across its heading [m]
  double depth = 0.0;    ///< along its heading [m]
  double heading = 0.0;  ///< [rad]
  double radius = 0.0;   ///< of the circle around it [m]
  std::size_t points = 0;
  double speed = 0.0;  ///< [m/s]
  std::string state;
};

/// Writes rows to a CSV file under the header that docs/cli promises; whole or not at all, as OutputFile does.
/// Row is OutlierRow, MetricsRow or ObstacleRow.
template <class Row>
class CsvTable {
 public:
  /// Throws Error where the file cannot be made.
  explicit CsvTable(const std::filesystem::path& path);
  void add(const Row& row);
  /// Makes the table appear. Call it once, last.
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
  std::string line_;
};

extern template class CsvTable<OutlierRow>;
extern template class CsvTable<MetricsRow>;
extern template class CsvTable<ObstacleRow>;

}  // namespace slamicp
