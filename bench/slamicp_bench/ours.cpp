// SPDX-License-Identifier: Apache-2.0
// This library: one row for each set of outputs and options worth telling apart.
#include <slamicp/registration/icp.hpp>

#include "field.hpp"

namespace slamicp::bench {
namespace {

struct Variant {
  std::string name;
  std::string what;
  Outputs wanted;
  IcpOptions icp;
};

IcpOptions paper_distances() {
  IcpOptions options;
  options.max_correspondence_distance = gate;
  options.max_iterations = max_iterations;
  options.translation_tolerance = options.rotation_tolerance = tolerance;
  return options;
}

Outputs all_but_the_map() {
  Outputs wanted = Outputs::all();
  wanted.updated_map = false;
  return wanted;
}

std::vector<Variant> variants() {
  std::vector<Variant> all{
      {"ours_pose", "slamicp, the pose", {}, paper_distances()},
      {reference_name, "slamicp, pose and outliers", {.outlier_indices = true}, paper_distances()},
      {"ours_all", "slamicp, all outputs but the updated map", all_but_the_map(), paper_distances()},
  };
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::sse4,
                                   InstructionSet::neon, InstructionSet::portable, InstructionSet::scalar}) {
    if (!is_available(set)) continue;
    IcpOptions options = paper_distances();
    options.instruction_set = set;
    all.push_back({std::string("by_") + to_string(set),
                   std::string("slamicp, pose and outliers by ") + to_string(set),
                   {.outlier_indices = true},
                   options});
  }
  return all;
}

class Ours : public Matcher {
 public:
  Ours(std::shared_ptr<const IndexedPoints<2>> map, const Variant& variant)
      : map_(std::move(map)), icp_(variant.icp), wanted_(variant.wanted) {}

  void localize(const PointCloud2& scan, const Pose2& guess, Estimate& estimate) override {
    const IcpResult2& result = icp_.align(*map_, scan, guess, wanted_);
    estimate.pose = result.pose;
    estimate.iterations = result.iterations;
    if (wanted_.outlier_indices) estimate.fresh_outliers() = result.outlier_indices;
  }

 private:
  std::shared_ptr<const IndexedPoints<2>> map_;
  Icp<2> icp_;
  Outputs wanted_;
};

}  // namespace

std::vector<Contender> ours() {
  std::vector<Contender> all;
  for (const Variant& variant : variants()) {
    const auto prepare = [variant](const SharedCloud& cloud) -> MakeMatcher {
      const auto map = std::make_shared<const IndexedPoints<2>>(*cloud);
      return [map, variant] { return std::make_unique<Ours>(map, variant); };
    };
    all.push_back({variant.name, variant.what, prepare});
  }
  return all;
}

}  // namespace slamicp::bench
