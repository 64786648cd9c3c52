// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <slamicp/registration/icp_result.hpp>

namespace slamicp {

const char* to_string(Stop stop) noexcept {
  switch (stop) {
    case Stop::converged:
      return "converged";
    case Stop::max_iterations:
      return "max_iterations";
    case Stop::degenerate:
      return "degenerate";
    case Stop::too_few_points:
      return "too_few_points";
    case Stop::no_overlap:
      return "no_overlap";
  }
  return "unknown";
}

template <int D>
std::string IcpResult<D>::brief() const {
  std::string line = std::string(slamicp::to_string(stop)) + " after " + std::to_string(iterations) +
                     " iterations at " + slamicp::to_string(pose);
  if (inliers > 0) {
    char text[64];
    std::snprintf(text, sizeof text, ", %zu inliers at %.4f m", inliers, mean_inlier_distance);
    line += text;
  }
  if (!outlier_indices.empty()) line += ", " + std::to_string(outlier_indices.size()) + " outliers";
  return line;
}

template struct IcpResult<2>;
template struct IcpResult<3>;

}  // namespace slamicp
