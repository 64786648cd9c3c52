// SPDX-License-Identifier: Apache-2.0
#include "oracle.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp::bench {

OutlierOracle::OutlierOracle(const PointCloud2& map, double limit) : limit_(limit), cell_size_(1.001 * limit) {
  entries_.reserve(map.size());
  for (const Point2& point : map) entries_.push_back({cell_of(point.x(), point.y()), point});
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.cell < b.cell; });
}

/// Column in the upper half, row in the lower: the rows of a column are neighbours.
std::uint64_t OutlierOracle::cell_of(double x, double y) const {
  const auto number = [&](double metres) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(metres / cell_size_)) + (1LL << 31));
  };
  return (number(x) << 32) + number(y);
}

bool OutlierOracle::any_closer(const Point2& point) const {
  for (const double dx : {-cell_size_, 0.0, cell_size_}) {
    const std::uint64_t last = cell_of(point.x() + dx, point.y() + cell_size_);
    const std::uint64_t first = cell_of(point.x() + dx, point.y() - cell_size_);
    const auto before = [](const Entry& entry, std::uint64_t cell) { return entry.cell < cell; };
    for (auto entry = std::lower_bound(entries_.begin(), entries_.end(), first, before);
         entry != entries_.end() && entry->cell <= last; ++entry)
      if ((entry->point - point).squaredNorm() < limit_ * limit_) return true;
  }
  return false;
}

std::vector<int> OutlierOracle::outliers(const PointCloud2& scan, const Pose2& T_map_robot) const {
  const Matrix<2, 2> rotation = T_map_robot.rotation();
  const Point2 translation = T_map_robot.translation();
  std::vector<int> found;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (!any_closer(rotation * scan[i] + translation)) found.push_back(static_cast<int>(i));
  return found;
}

}  // namespace slamicp::bench
