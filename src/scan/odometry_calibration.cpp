// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/scan/odometry_calibration.hpp>

#include "geometry/symmetric_eigen.hpp"

namespace slamicp {
namespace {

Vector<3> parameters_of(const DifferentialDrive& drive) {
  return {drive.left_radius, drive.right_radius, drive.wheel_distance};
}
DifferentialDrive with(DifferentialDrive drive, const Vector<3>& p) {
  drive.left_radius = p[0];
  drive.right_radius = p[1];
  drive.wheel_distance = p[2];
  return drive;
}

Vector<4> parameters_of(const OmniDrive& drive) {
  return {drive.radii[0], drive.radii[1], drive.radii[2], drive.base_radius};
}
OmniDrive with(OmniDrive drive, const Vector<4>& p) {
  drive.radii = {p[0], p[1], p[2]};
  drive.base_radius = p[3];
  return drive;
}

Vector<3> parameters_of(const OdometryScale& scale) {
  return {scale.translation, scale.rotation, scale.drift_per_metre};
}
OdometryScale with(OdometryScale, const Vector<3>& p) { return {p[0], p[1], p[2]}; }

template <class Model, class Reading>
class Fit {
  using Parameters = decltype(parameters_of(Model()));
  static constexpr int n = Parameters::RowsAtCompileTime;

 public:
  Fit(const Model& nominal, std::span<const DriveStretch<Reading>> stretches, const CalibrationOptions& options)
      : nominal_(nominal),
        stretches_(stretches),
        weights_(1.0 / options.fix_translation, 1.0 / options.fix_translation, 1.0 / options.fix_rotation) {}

  OdometryCalibration<Model> run() {
    OdometryCalibration<Model> result;
    Parameters p = parameters_of(nominal_);
    result.model = nominal_;
    result.sigmas.assign(n, INFINITY);
    result.rms_before = result.rms_after = rms(p);
    const auto residuals = static_cast<double>(3 * stretches_.size());
    if (residuals <= n) return result;
    for (int step = 0; step < steps; ++step) {
      linearize(p);
      if (!is_determined()) return result;
      p += information_.inverse() * gradient_;
      if (!p.allFinite() || !with(nominal_, p).problem().empty()) return result;
    }
    linearize(p);
    const double variance = squares_ / (residuals - n);
    const Information covariance = variance * information_.inverse();
    for (int k = 0; k < n; ++k) result.sigmas[static_cast<std::size_t>(k)] = std::sqrt(covariance(k, k));
    result.model = with(nominal_, p);
    result.rms_after = rms(p);
    result.determined = true;
    return result;
  }

 private:
  using Information = Eigen::Matrix<double, n, n>;
  static constexpr int steps = 8;

  Pose2::Tangent off(const DriveStretch<Reading>& stretch, const Parameters& p) const {
    const Model model = with(nominal_, p);
    Pose2 moved;
    for (const Reading& reading : stretch.readings) moved = moved * model.motion(reading);
    return (moved.inverse() * stretch.T_start_end).log();
  }

  double rms(const Parameters& p) const {
    double sum = 0.0;
    for (const auto& stretch : stretches_) sum += off(stretch, p).template head<2>().squaredNorm();
    return stretches_.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(stretches_.size()));
  }

  /// Normal equations around `p`; derivatives by central differences, as the models are smooth and the fit is rare.
  void linearize(const Parameters& p) {
    information_.setZero();
    gradient_.setZero();
    squares_ = 0.0;
    for (const auto& stretch : stretches_) {
      const Eigen::Vector3d residual = weights_.cwiseProduct(off(stretch, p));
      Eigen::Matrix<double, 3, n> jacobian;
      for (int k = 0; k < n; ++k) {
        const double h = 1e-6 * std::max(1.0, std::abs(p[k]));
        Parameters up = p, down = p;
        up[k] += h;
        down[k] -= h;
        jacobian.col(k) = weights_.cwiseProduct(off(stretch, down) - off(stretch, up)) / (2.0 * h);
      }
      information_ += jacobian.transpose() * jacobian;
      gradient_ += jacobian.transpose() * residual;
      squares_ += residual.squaredNorm();
    }
  }

  /// Whether every combination of parameters shows: scaled, so that a radius and a distance compare.
  bool is_determined() const {
    const Parameters diagonal = information_.diagonal();
    if (!(diagonal.minCoeff() > 0.0)) return false;
    const Parameters scale = diagonal.cwiseSqrt().cwiseInverse();
    const Information scaled = scale.asDiagonal() * information_ * scale.asDiagonal();
    return SymmetricEigen<n>(scaled).values.minCoeff() > 1e-6;
  }

  const Model& nominal_;
  std::span<const DriveStretch<Reading>> stretches_;
  Eigen::Vector3d weights_;
  Information information_ = Information::Zero();
  Parameters gradient_ = Parameters::Zero();
  double squares_ = 0.0;
};

template <class Model, class Reading>
OdometryCalibration<Model> fit(const Model& nominal, std::span<const DriveStretch<Reading>> stretches,
                               const CalibrationOptions& options) {
  if (const std::string problem = nominal.problem(); !problem.empty()) throw Error(problem, "the nominal model");
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "CalibrationOptions");
  return Fit<Model, Reading>(nominal, stretches, options).run();
}

}  // namespace

std::string CalibrationOptions::problem() const {
  if (!(fix_translation > 0.0 && std::isfinite(fix_translation))) return "fix_translation must be above 0 m";
  if (!(fix_rotation > 0.0 && std::isfinite(fix_rotation))) return "fix_rotation must be above 0 rad";
  return {};
}

OdometryCalibration<DifferentialDrive> calibrate(const DifferentialDrive& nominal,
                                                 std::span<const DriveStretch<WheelTurns<2>>> stretches,
                                                 const CalibrationOptions& options) {
  return fit(nominal, stretches, options);
}

OdometryCalibration<OmniDrive> calibrate(const OmniDrive& nominal,
                                         std::span<const DriveStretch<WheelTurns<3>>> stretches,
                                         const CalibrationOptions& options) {
  return fit(nominal, stretches, options);
}

OdometryCalibration<OdometryScale> calibrate(const OdometryScale& nominal,
                                             std::span<const DriveStretch<Pose2>> stretches,
                                             const CalibrationOptions& options) {
  return fit(nominal, stretches, options);
}

}  // namespace slamicp
