// SPDX-License-Identifier: Apache-2.0
// The paper's original software agent (section 3.3, Figure 9a): the ICP hands out nothing but the pose, so the
// outliers are found again by comparing the transformed scan with the whole map.
#include "brute_force.hpp"
#include "field.hpp"
#include "tree_icp.hpp"

namespace slamicp::bench {
namespace {

/// The map's coordinates, axis by axis.
template <class Real>
class Columns {
 public:
  explicit Columns(const PointCloud2& cloud) {
    x_.reserve(cloud.size());
    y_.reserve(cloud.size());
    for (const Point2& point : cloud) {
      x_.push_back(static_cast<Real>(point.x()));
      y_.push_back(static_cast<Real>(point.y()));
    }
  }
  Coordinates<Real> view() const { return {x_.data(), y_.data(), x_.size()}; }

 private:
  std::vector<Real> x_, y_;
};

/// Looks at all pairs, one by one.
struct AllPairs {
  explicit AllPairs(const PointCloud2& cloud) : map(cloud) {}
  bool is_outlier(const Point2& point) const {
    return squared_distance_scalar(map.view(), point.x(), point.y()) >= gate * gate;
  }
  Columns<double> map;
};

/// Looks at all pairs, as many at once as the processor can.
struct AllPairsVectorized {
  explicit AllPairsVectorized(const PointCloud2& cloud) : map(cloud) {}
  bool is_outlier(const Point2& point) const {
    const auto limit = static_cast<float>(gate);
    return squared_distance_vectorized(map.view(), static_cast<float>(point.x()), static_cast<float>(point.y())) >=
           limit * limit;
  }
  Columns<float> map;
};

/// Goes through the map until a point is near enough.
struct FirstNear {
  explicit FirstNear(const PointCloud2& cloud) : map(cloud) {}
  bool is_outlier(const Point2& point) const { return !any_closer(map.view(), point.x(), point.y(), gate * gate); }
  Columns<double> map;
};

/// @param tree  none: it is built at every call, as the paper's MATLAB wrapper does
template <class BruteForce>
class OriginalAgent : public Matcher {
 public:
  OriginalAgent(SharedCloud cloud, std::shared_ptr<const TreeMap> tree, std::shared_ptr<const BruteForce> brute_force)
      : cloud_(std::move(cloud)), tree_(std::move(tree)), brute_force_(std::move(brute_force)) {}

  void localize(const PointCloud2& scan, const Pose2& guess, Estimate& estimate) override {
    const TreeIcp::Result result = tree_ ? icp_.align(*tree_, scan, guess) : icp_.align(TreeMap(*cloud_), scan, guess);
    estimate.pose = result.pose;
    estimate.iterations = result.iterations;
    transform(scan, result.pose, in_map_);
    std::vector<int>& outliers = estimate.fresh_outliers();
    for (std::size_t i = 0; i < in_map_.size(); ++i)
      if (brute_force_->is_outlier(in_map_[i])) outliers.push_back(static_cast<int>(i));
  }

 private:
  SharedCloud cloud_;
  std::shared_ptr<const TreeMap> tree_;
  std::shared_ptr<const BruteForce> brute_force_;
  TreeIcp icp_;
  PointCloud2 in_map_;
};

template <class BruteForce>
Contender agent(std::string name, std::string what, bool rebuild = false) {
  const auto prepare = [rebuild](const SharedCloud& cloud) -> MakeMatcher {
    const auto tree = rebuild ? nullptr : std::make_shared<const TreeMap>(*cloud);
    const auto brute_force = std::make_shared<const BruteForce>(*cloud);
    return [=] { return std::make_unique<OriginalAgent<BruteForce>>(cloud, tree, brute_force); };
  };
  return {std::move(name), std::move(what), prepare};
}

}  // namespace

std::vector<Contender> original_agents() {
  return {agent<AllPairs>("original", "the paper's original agent, its tree built once"),
          agent<AllPairs>("original_rebuilt", "the paper's original agent, its tree built at every call", true),
          agent<AllPairsVectorized>("original_vectorized", "original, with a vectorized brute force in float"),
          agent<FirstNear>("original_first_near", "original, with a brute force that stops at the first near point")};
}

}  // namespace slamicp::bench
