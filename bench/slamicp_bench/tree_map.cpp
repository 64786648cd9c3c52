// SPDX-License-Identifier: Apache-2.0
#include "tree_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>

namespace slamicp::bench {
namespace {

constexpr std::size_t leaf_size = 10;
constexpr std::size_t line_neighbours = 10;

/// What nanoflann asks of a cloud.
struct View {
  const PointCloud2& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t k, std::size_t axis) const { return points[k][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, View>, View, 2, std::uint32_t>;

}  // namespace

struct TreeMap::Tree {
  explicit Tree(const PointCloud2& cloud) : view{cloud}, index(2, view, {leaf_size}) {}

  View view;
  Index index;
};

TreeMap::TreeMap(const PointCloud2& cloud) : cloud_(cloud), tree_(std::make_unique<Tree>(cloud)) {
  normals_.reserve(cloud.size());
  for (const Point2& point : cloud) normals_.push_back(normal_around(point));
}

TreeMap::~TreeMap() = default;

Neighbour TreeMap::nearest(const Point2& query) const {
  std::uint32_t index = 0;
  Neighbour neighbour;
  if (tree_->index.knnSearch(query.data(), 1, &index, &neighbour.squared_distance) == 1)
    neighbour.index = static_cast<int>(index);
  return neighbour;
}

/// Across the direction in which the neighbours spread most (principal component analysis).
Vector<2> TreeMap::normal_around(const Point2& point) const {
  std::array<std::uint32_t, line_neighbours> indices{};
  std::array<double, line_neighbours> squared_distances{};
  const std::size_t found =
      tree_->index.knnSearch(point.data(), line_neighbours, indices.data(), squared_distances.data());
  Point2 centroid = Point2::Zero();
  for (std::size_t k = 0; k < found; ++k) centroid += cloud_[indices[k]];
  centroid /= static_cast<double>(found);
  Matrix<2, 2> scatter = Matrix<2, 2>::Zero();
  for (std::size_t k = 0; k < found; ++k) {
    const Vector<2> off = cloud_[indices[k]] - centroid;
    scatter += off * off.transpose();
  }
  const double along = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  return {-std::sin(along), std::cos(along)};
}

}  // namespace slamicp::bench
