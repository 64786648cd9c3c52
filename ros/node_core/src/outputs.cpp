// SPDX-License-Identifier: Apache-2.0
#include "outputs.hpp"

#include <cmath>

namespace slamicp::node {

PlanarPose to_message(const Pose2& pose) { return {pose.x, pose.y, pose.theta}; }

void tell_fix(const Fix& fix, Output& output) {
  output.pose = to_message(fix.pose);
  output.covariance.fill(0.0);
  const Matrix<3, 3> covariance = fix.covariance_in_map();
  constexpr std::size_t place[3] = {0, 1, 5};  // x, y, about z
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      output.covariance[6 * place[row] + place[column]] =
          covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));

  Status& status = output.status;
  status.tracking = to_string(fix.quality.state);
  status.stop = to_string(fix.stop());
  status.usable = fix.usable();
  status.probability = fix.quality.probability;
  status.awareness = fix.quality.awareness;
  status.blind = !fix.blind_direction.isZero();
  status.blind_x = fix.blind_direction.x();
  status.blind_y = fix.blind_direction.y();
  status.carried_by = to_string(fix.carried_by);
  status.points = static_cast<int>(fix.scan.in_robot.size());
  status.inliers = static_cast<int>(fix.match.inliers);
  status.outliers = static_cast<int>(fix.outliers().size());
  status.iterations = fix.match.iterations;
}

void tell_points(const Fix& fix, const Pose3& T_base_laser, Output& output) {
  output.outliers.clear();
  output.inliers.clear();
  const Pose3 T_laser_base = T_base_laser.inverse();
  const Matrix<3, 3> rotation = T_laser_base.rotation();
  const std::vector<int>& outliers = fix.outliers();  // rising
  std::size_t next = 0;
  for (std::size_t k = 0; k < fix.scan.in_robot.size(); ++k) {
    const Point2& in_robot = fix.scan.in_robot[k];
    const Point3 in_laser =
        rotation * Point3(in_robot.x(), in_robot.y(), T_base_laser.position.z()) + T_laser_base.position;
    const bool is_outlier = next < outliers.size() && static_cast<std::size_t>(outliers[next]) == k;
    if (is_outlier) ++next;
    (is_outlier ? output.outliers : output.inliers)
        .push_back(
            {static_cast<float>(in_laser.x()), static_cast<float>(in_laser.y()), static_cast<float>(in_laser.z())});
  }
}

void tell_obstacles(std::span<const slamicp::Obstacle> found, std::span<const Track> tracks, Output& output) {
  output.obstacles.resize(found.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Shape& shape = found[k].shape;
    Obstacle& told = output.obstacles[k];
    told.id = 0;
    told.kind = to_string(shape.kind);
    told.state = "undecided";
    told.x = shape.centre.x();
    told.y = shape.centre.y();
    told.heading = shape.heading;
    told.width = shape.width;
    told.depth = shape.depth;
    told.radius = shape.radius;
    told.velocity_x = told.velocity_y = 0.0;
    told.distance = found[k].distance;
    told.points = static_cast<int>(found[k].points.size());
    for (const Track& track : tracks) {
      if (track.obstacles[0] != static_cast<int>(k) && track.obstacles[1] != static_cast<int>(k)) continue;
      told.id = track.id;
      told.state = word_of(track);
      told.velocity_x = track.velocity.x();
      told.velocity_y = track.velocity.y();
    }
  }
}

}  // namespace slamicp::node
