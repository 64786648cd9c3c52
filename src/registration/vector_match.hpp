// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/registration/icp_result.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "registration/pass/choose.hpp"
#include "registration/step.hpp"

namespace slamicp {

/// The match in the plane, many points at a time: what Correspondences and the steps over them do, by passes over the
/// cells' tables. In float; what a rounding could decide, and what the tables cannot answer, is decided in double.
class VectorMatch {
 public:
  explicit VectorMatch(const pass::Passes* passes) noexcept : passes_(passes) {}

  /// False: this machine or build has no passes of the kind asked for.
  bool exists() const noexcept { return passes_ != nullptr; }

  void reserve(std::size_t points);

  /// Reads a scan. @returns how many of its points are numbers
  std::size_t begin(const CellIndex& map, PointView<2> scan);

  Step<2> point_to_surface_step(const StepInput<2>& input) noexcept;
  Step<2> point_to_point_step(const StepInput<2>& input) noexcept;

  /// Appends the points that are at least `threshold` from every map point.
  void find_outliers(const Pose2& pose, double threshold, std::vector<int>& indices) noexcept;

  /// Finds the nearest map point of every scan point, closer than `reach`.
  void find_matches(const Pose2& pose, double reach) noexcept;
  /// That of scan point i, and its distance [m].
  std::pair<Neighbour, double> match(std::size_t i, const Pose2& pose) const noexcept {
    const std::int32_t number = numbers_[i];
    if (number >= 0 && squared_distances_[i] < reach_ * reach_) return {{number, squared_distances_[i]}, distances_[i]};
    Neighbour nearest;
    if (number == pass::ask || (number == pass::no_match && reaches_beyond_))
      nearest = map_->nearest(pose * scan_[i], reach_);
    return {nearest, std::sqrt(nearest.squared_distance)};
  }

  /// Points looked up since begin().
  std::size_t searches() const noexcept { return searches_; }

 private:
  pass::ScanColumns columns() const noexcept {
    return {x_.data(), y_.data(), static_cast<std::uint32_t>(scan_.size())};
  }
  pass::Window window_at(const Pose2& pose) noexcept;
  pass::Place place_of(const Pose2& pose) const noexcept;
  pass::Request request(const StepInput<2>& input) noexcept;
  Point2 corner() const noexcept;
  void open_window(int column, int row) noexcept;
  double tiles_to_see() const noexcept;
  double most_tiles_to_see() const noexcept;
  double margin() const noexcept;
  pass::Limit limit(double distance) const noexcept;

  const pass::Passes* passes_;
  const CellIndex* map_ = nullptr;
  PointView<2> scan_;
  std::size_t searches_ = 0;
  float farthest_ = 0.0F;       // coordinate of a scan point [m]
  std::uint32_t far_ones_ = 0;  // points farther than that, too far for float
  std::vector<float> x_, y_;
  std::vector<std::uint32_t> list_;
  std::vector<std::int32_t> numbers_;
  std::vector<double> squared_distances_, distances_;
  double reach_ = 0.0;           // of the matches
  bool reaches_beyond_ = false;  // what the tables list

  // The tables around the robot, kept while it stays near and the map is the same.
  std::vector<const CellTable*> tables_;
  std::uint64_t tables_of_ = 0;     // CellIndex::id
  std::uint64_t tables_built_ = 0;  // CellIndex::builds
  int width_ = 0;
  int left_ = 0, bottom_ = 0;
  int column_ = 0, row_ = 0;  // of the tile the robot is in
};

}  // namespace slamicp
