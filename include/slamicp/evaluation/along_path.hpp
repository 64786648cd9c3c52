// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <slamicp/evaluation/recorded_drive.hpp>

namespace slamicp {

/// A value of each scan of a drive, by the distance travelled, whatever the speed: at 0, step, 2 step, ... metres up to
/// `length` the value of the scan nearest to there.
/// @param step  [m], > 0
std::vector<double> along_path(const RecordedDrive& drive, const std::function<double(const DriveSample&)>& value,
                               double length, double step);

/// How much curves along a path differ, root mean square over the path.
struct CurveSpread {
  double between_groups = 0.0;  ///< standard deviation of the groups' mean curves around the mean of all
  double within_groups = 0.0;   ///< standard deviation of the curves around their group's mean: from run to run
};

/// Of several groups (speeds) of several curves (runs) each. Values that are not finite, or lie beyond a shorter curve,
/// are left out with their place. Groups of one curve have no spread within. Throws Error without groups, or for an
/// empty one.
CurveSpread spread_of(const std::vector<std::vector<std::vector<double>>>& groups);

/// The mean of curves, place by place, as far as the shortest reaches.
std::vector<double> mean_curve(const std::vector<std::vector<double>>& curves);

}  // namespace slamicp
