// SPDX-License-Identifier: Apache-2.0
#include <slamicp/localization/fix.hpp>

namespace slamicp {

const char* to_string(Carrier carrier) noexcept {
  switch (carrier) {
    case Carrier::scan:
      return "scan";
    case Carrier::odometry:
      return "odometry";
    case Carrier::velocity:
      return "velocity";
  }
  return "unknown";
}

Matrix<3, 3> Fix::covariance_in_map() const noexcept {
  Matrix<3, 3> turn = Matrix<3, 3>::Identity();
  turn.topLeftCorner<2, 2>() = pose.rotation();
  return turn * covariance * turn.transpose();
}

}  // namespace slamicp
