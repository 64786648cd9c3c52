// SPDX-License-Identifier: Apache-2.0
#include "registration/vector_match.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp {
namespace {

// Tiles that the robot can move before the window is opened anew, and the most from its middle to its edge.
constexpr int to_spare = 4;
constexpr int most_tiles = 120;
// Farther than this, rounding to float comes near what a cell's list holds beyond its cell [m].
constexpr double farthest_in_float = 100.0;

const double* xy_of(PointView<2> points) noexcept {
  static constexpr double none[2] = {0.0, 0.0};
  return points.empty() ? none : points.front().data();
}

Eigen::Matrix3d symmetric(const pass::Square& sums) noexcept {
  Eigen::Matrix3d square;
  square << sums.xx, sums.xy, sums.xt, sums.xy, sums.yy, sums.yt, sums.xt, sums.yt, sums.tt;
  return square;
}

/// @param turn  from the map's axes into the robot's, for the unknowns
NoiseSums in_robot(const pass::LineNoiseSums& sums, const Eigen::Matrix3d& turn) noexcept {
  NoiseSums noise;
  noise.by_range = turn * symmetric(sums.by_range) * turn.transpose();
  noise.by_map = turn * symmetric(sums.by_map) * turn.transpose();
  noise.together = turn * symmetric(sums.together) * turn.transpose();
  noise.weights = sums.weights;
  noise.moment = turn.topLeftCorner<2, 2>() * Point2(sums.x, sums.y);
  noise.squared_ranges = sums.squared_ranges;
  noise.squared_residuals = sums.squared_residuals;
  noise.squared_cosines = sums.squared_cosines;
  noise.sharing = sums.sharing;
  return noise;
}

}  // namespace

void VectorMatch::reserve(std::size_t points) {
  x_.resize(std::max(x_.size(), points + pass::padding));
  y_.resize(std::max(y_.size(), points + pass::padding));
  list_.resize(std::max(list_.size(), points + pass::padding));
  numbers_.resize(std::max(numbers_.size(), points));
  squared_distances_.resize(std::max(squared_distances_.size(), points));
  distances_.resize(std::max(distances_.size(), points));
  constexpr std::size_t widest = 2 * std::size_t{most_tiles} + 1;
  tables_.reserve(widest * widest + 1);
}

std::size_t VectorMatch::begin(const CellIndex& map, PointView<2> scan) {
  map_ = &map;
  scan_ = scan;
  searches_ = 0;
  reserve(scan.size());
  const auto count = static_cast<std::uint32_t>(scan.size());
  return passes_->to_columns(xy_of(scan), count, x_.data(), y_.data(), &farthest_, &far_ones_);
}

/// How many tiles a scan reaches in one direction, and how many at most the window holds.
double VectorMatch::tiles_to_see() const noexcept {
  return std::ceil(std::sqrt(2.0) * static_cast<double>(farthest_) / map_->tile());
}
double VectorMatch::most_tiles_to_see() const noexcept {
  return std::min(static_cast<double>(most_tiles - to_spare), std::floor(farthest_in_float / map_->tile()));
}

/// Opens the window on the tiles around the robot's.
void VectorMatch::open_window(int column, int row) noexcept {
  const double tiles = tiles_to_see();
  const int half = static_cast<int>(std::min(tiles, most_tiles_to_see())) + to_spare;
  width_ = 2 * half + 1;
  left_ = column - half;
  bottom_ = row - half;
  tables_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(width_) + 1);
  tables_of_ = map_->id();
  tables_built_ = map_->builds();
  map_->tables(left_, bottom_, width_, std::span(tables_).first(tables_.size() - 1));
}

pass::Window VectorMatch::window_at(const Pose2& pose) noexcept {
  constexpr double last = 1e8;
  column_ = static_cast<int>(std::floor(std::clamp(pose.x / map_->tile(), -last, last)));
  row_ = static_cast<int>(std::floor(std::clamp(pose.y / map_->tile(), -last, last)));
  const int half = width_ / 2;
  const bool is_near = std::abs(column_ - left_ - half) <= to_spare && std::abs(row_ - bottom_ - half) <= to_spare;
  const bool is_wide = half - to_spare >= std::min(tiles_to_see(), most_tiles_to_see());
  const bool is_current = tables_of_ == map_->id() && tables_built_ == map_->builds();
  if (!is_near || !is_wide || !is_current) open_window(column_, row_);
  // What lies outside is asked for one by one, but for a window as wide as the scan.
  const bool sees_all = far_ones_ == 0 && tiles_to_see() <= most_tiles_to_see();
  tables_.back() = sees_all ? &CellIndex::empty_table() : &CellIndex::unbuilt_table();
  return {tables_.data(),
          width_,
          column_ - left_,
          row_ - bottom_,
          static_cast<float>(1.0 / map_->cell()),
          static_cast<float>(map_->tile()),
          static_cast<float>(1.0 / map_->place_unit())};
}

Point2 VectorMatch::corner() const noexcept { return {column_ * map_->tile(), row_ * map_->tile()}; }

pass::Place VectorMatch::place_of(const Pose2& pose) const noexcept {
  const Point2 from_corner = pose.translation() - corner();
  return {static_cast<float>(std::cos(pose.theta)), static_cast<float>(std::sin(pose.theta)),
          static_cast<float>(from_corner.x()), static_cast<float>(from_corner.y())};
}

/// How far a distance can be off by rounding [m], and more: to float in the scan, to units in the places, and by what
/// tells candidates apart.
double VectorMatch::margin() const noexcept {
  return std::max(1e-5, 4e-7 * static_cast<double>(farthest_)) + 2.0 * map_->place_unit();
}

pass::Limit VectorMatch::limit(double distance) const noexcept {
  // Squared distances lose their lowest bits; and what lies a cell beyond the reach is no candidate, but may stand for
  // none.
  constexpr double lost = 15.0;
  const double most = (map_->cell_options().reach + map_->cell()) / map_->place_unit();
  const double sure = std::max(distance - margin(), 0.0) / map_->place_unit();
  const double beyond = std::min((distance + margin()) / map_->place_unit(), most);
  return {static_cast<std::uint32_t>(std::max(std::min(sure, most) * std::min(sure, most) - lost, 0.0)),
          static_cast<std::uint32_t>(beyond * beyond)};
}

pass::Request VectorMatch::request(const StepInput<2>& input) noexcept {
  searches_ += (input.scan.size() - input.stride / 2 + input.stride - 1) / input.stride;
  const pass::Window window = window_at(input.pose);
  const Vector<2> ray = input.noise ? Vector<2>(input.pose.rotation() * input.noise->rays.origin) : Vector<2>::Zero();
  return {columns(),
          static_cast<std::uint32_t>(input.stride),
          window,
          place_of(input.pose),
          limit(std::min(input.gate, map_->cell_options().reach)),
          input.gate > map_->cell_options().reach,
          input.kernel,
          static_cast<float>(input.kernel_scale),
          xy_of(map_->points()),
          corner().x(),
          corner().y(),
          list_.data(),
          input.noise != nullptr,
          static_cast<float>(ray.x()),
          static_cast<float>(ray.y()),
          input.noise ? static_cast<float>(input.noise->sharing()) : 0.0F};
}

Step<2> VectorMatch::point_to_surface_step(const StepInput<2>& input) noexcept {
  pass::LineSums sums;
  passes_->lines(request(input), &sums);
  // From the map's axes into the robot's: the unknowns turn with the pose.
  Eigen::Matrix3d information;
  information << sums.xx, sums.xy, sums.xt, sums.xy, sums.yy, sums.yt, sums.xt, sums.yt, sums.tt;
  Eigen::Matrix3d into_robot = Eigen::Matrix3d::Identity();
  const Matrix<2, 2> turn = input.pose.rotation().transpose();
  into_robot.topLeftCorner<2, 2>() = turn;
  NormalEquations<2> equations;
  equations.information = into_robot * information * into_robot.transpose();
  equations.gradient = into_robot * Eigen::Vector3d(sums.x, sums.y, sums.t);
  equations.squared_ranges = sums.squared_ranges;
  equations.pairs = sums.pairs;
  if (input.noise) equations.noise = in_robot(sums.noise, into_robot);
  for (const std::uint32_t i : std::span(list_).first(sums.undecided)) {
    const Point2 in_map = input.pose * scan_[i];
    const Neighbour nearest = map_->nearest(in_map, input.gate);
    if (nearest.found())
      equations.add(input, scan_[i], in_map, map_->surface(static_cast<std::size_t>(nearest.index)), turn);
  }
  return slamicp::point_to_surface_step(input, equations);
}

Step<2> VectorMatch::point_to_point_step(const StepInput<2>& input) noexcept {
  pass::PointSums sums;
  passes_->points(request(input), &sums);
  // About the robot, not the corner of its tile.
  PairSums<2> pairs;
  const Point2 shift = corner() - input.pose.translation();
  pairs.weights = sums.weight;
  pairs.source = {sums.px, sums.py};
  pairs.target = Point2(sums.mx, sums.my) + sums.weight * shift;
  pairs.products << sums.mx_px, sums.mx_py, sums.my_px, sums.my_py;
  pairs.products += shift * pairs.source.transpose();
  pairs.squared_ranges = sums.squared_ranges;
  pairs.pairs = sums.pairs;
  for (const std::uint32_t i : std::span(list_).first(sums.undecided)) {
    const Neighbour nearest = map_->nearest(input.pose * scan_[i], input.gate);
    if (!nearest.found()) continue;
    const Point2 target = map_->points()[static_cast<std::size_t>(nearest.index)] - input.pose.translation();
    pairs.add(scan_[i], target, kernel_weight(input.kernel, std::sqrt(nearest.squared_distance), input.kernel_scale));
  }
  return slamicp::point_to_point_step(input, pairs, input.pose.translation());
}

void VectorMatch::find_outliers(const Pose2& pose, double threshold, std::vector<int>& indices) noexcept {
  const pass::Window window = window_at(pose);
  const double unit = map_->distance_unit();
  const double reach = map_->cell_options().reach;
  const auto bound = [&](double distance) {
    return static_cast<std::uint32_t>(std::clamp(distance / unit, 0.0, 64.0));
  };
  // A bound of 63 units says nothing from above; from below it says at least the reach.
  const std::uint32_t inside = std::min(bound(threshold - margin()), CellTable::farthest - 1);
  const std::uint32_t beyond = bound(threshold + margin()) + 1;
  const std::uint32_t outside = threshold <= reach ? std::min(beyond, CellTable::farthest) : 64;
  const std::uint32_t count = passes_->outliers({columns(), window, place_of(pose), limit(std::min(threshold, reach)),
                                                 threshold > reach, inside, outside, list_.data()});
  for (const std::uint32_t found : std::span(list_).first(count)) {
    const std::uint32_t i = found & ~pass::unsure;
    if (found != i && map_->nearest(pose * scan_[i], threshold).found()) continue;
    indices.push_back(static_cast<int>(i));
  }
}

void VectorMatch::find_matches(const Pose2& pose, double reach) noexcept {
  const pass::Window window = window_at(pose);
  searches_ += scan_.size();
  reach_ = reach;
  reaches_beyond_ = reach > map_->cell_options().reach;
  const double roundings = 3.0 * map_->place_unit() + std::max(1e-5, 8e-7 * static_cast<double>(farthest_));
  const Matrix<2, 2> rotation = pose.rotation();
  passes_->matches({columns(), window, place_of(pose), limit(map_->cell_options().reach),
                    static_cast<float>(roundings / map_->place_unit()), xy_of(scan_), rotation(0, 0), rotation(1, 0),
                    pose.x, pose.y, xy_of(map_->points()), numbers_.data(), squared_distances_.data(),
                    distances_.data()});
}

}  // namespace slamicp
