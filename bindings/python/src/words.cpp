// SPDX-License-Identifier: Apache-2.0
#include "words.hpp"

#include "refusal.hpp"

namespace slamicp::python {

Method method_named(const std::string& name) {
  if (name == "point_to_point") return Method::point_to_point;
  if (name == "point_to_line" || name == "point_to_plane") return Method::point_to_line;
  throw c::Refusal(SLAMICP_BAD_OPTIONS,
                   "there is no method '" + name + "'; give 'point_to_point', 'point_to_line' or 'point_to_plane'");
}

RobustKernel kernel_named(const std::string& name) {
  if (name == "none") return RobustKernel::none;
  if (name == "huber") return RobustKernel::huber;
  if (name == "cauchy") return RobustKernel::cauchy;
  if (name == "geman_mcclure") return RobustKernel::geman_mcclure;
  if (name == "tukey") return RobustKernel::tukey;
  throw c::Refusal(SLAMICP_BAD_OPTIONS,
                   "there is no kernel '" + name + "'; give 'none', 'huber', 'cauchy', 'geman_mcclure' or 'tukey'");
}

}  // namespace slamicp::python
