// SPDX-License-Identifier: Apache-2.0
// The paper's improved software agent (section 3.3, Figure 9b): the same ICP, and the outliers fall out of its tree at
// the final pose.
#include "field.hpp"
#include "tree_icp.hpp"

namespace slamicp::bench {
namespace {

/// @param tree  none: it is built at every call, as the paper's MATLAB wrapper does
class ImprovedAgent : public Matcher {
 public:
  ImprovedAgent(SharedCloud cloud, std::shared_ptr<const TreeMap> tree)
      : cloud_(std::move(cloud)), tree_(std::move(tree)) {}

  void localize(const PointCloud2& scan, const Pose2& guess, Estimate& estimate) override {
    if (tree_)
      localize_in(*tree_, scan, guess, estimate);
    else
      localize_in(TreeMap(*cloud_), scan, guess, estimate);
  }

 private:
  void localize_in(const TreeMap& map, const PointCloud2& scan, const Pose2& guess, Estimate& estimate) {
    const TreeIcp::Result result = icp_.align(map, scan, guess);
    estimate.pose = result.pose;
    estimate.iterations = result.iterations;
    transform(scan, result.pose, in_map_);
    std::vector<int>& outliers = estimate.fresh_outliers();
    for (std::size_t i = 0; i < in_map_.size(); ++i)
      if (map.nearest(in_map_[i]).squared_distance >= gate * gate) outliers.push_back(static_cast<int>(i));
  }

  SharedCloud cloud_;
  std::shared_ptr<const TreeMap> tree_;
  TreeIcp icp_;
  PointCloud2 in_map_;
};

Contender agent(std::string name, std::string what, bool rebuild) {
  const auto prepare = [rebuild](const SharedCloud& cloud) -> MakeMatcher {
    const auto tree = rebuild ? nullptr : std::make_shared<const TreeMap>(*cloud);
    return [=] { return std::make_unique<ImprovedAgent>(cloud, tree); };
  };
  return {std::move(name), std::move(what), prepare};
}

}  // namespace

std::vector<Contender> improved_agents() {
  return {agent("improved", "the paper's improved agent, its tree built once", false),
          agent("improved_rebuilt", "the paper's improved agent, its tree built at every call", true)};
}

}  // namespace slamicp::bench
