// SPDX-License-Identifier: Apache-2.0
#include "agent/self_localization.hpp"

namespace slamicp {
namespace {

/// Figure 9b: the outliers fall out of the match.
class ImprovedLocalization : public SelfLocalization {
 public:
  ImprovedLocalization(PointMap2::Pointer map, const AgentOptions& options)
      : localizer_(std::move(map), options.localization), rebuild_(options.rebuild_index) {}

  void set_pose(const Pose2& pose) override { localizer_.set_pose(pose); }

  void localize(const LaserScan& scan) override {
    if (rebuild_) localizer_.set_map(PointMap2::create(to_cloud<2>(localizer_.map()->points()), {}, {.eager = false}));
    localizer_.update(scan);
  }

  void find_discrepancies() override {}
  const Fix& fix() const noexcept override { return localizer_.fix(); }

 private:
  Localizer localizer_;
  bool rebuild_;
};

}  // namespace

std::unique_ptr<SelfLocalization> improved_localization(PointMap2::Pointer map, const AgentOptions& options) {
  return std::make_unique<ImprovedLocalization>(std::move(map), options);
}

}  // namespace slamicp
