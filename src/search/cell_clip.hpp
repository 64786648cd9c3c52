// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace slamicp {

/// What is left of a square cell for one point's Voronoi cell: a convex polygon, cut by one half-plane after the other.
/// Coordinates are relative to the cell's centre.
class CellClip {
 public:
  /// @param half  half the side of the square [m]
  explicit CellClip(double half) noexcept : count_(4) {
    x_[0] = x_[3] = y_[0] = y_[1] = -half;
    x_[1] = x_[2] = y_[2] = y_[3] = half;
  }

  bool empty() const noexcept { return count_ == 0; }

  /// Keeps what is nearer to (px, py) than to (qx, qy); where both are as near, to `slack`, stays too.
  void keep_nearer(double px, double py, double qx, double qy) noexcept {
    const double ax = 2.0 * (qx - px);
    const double ay = 2.0 * (qy - py);
    const double limit = qx * qx + qy * qy - px * px - py * py + slack;
    std::array<double, most> beyond;
    bool cuts = false;
    for (std::size_t k = 0; k < count_; ++k) {
      beyond[k] = ax * x_[k] + ay * y_[k] - limit;
      cuts = cuts || beyond[k] > 0.0;
    }
    if (!cuts || count_ + 1 >= most) return;  // with too many corners to keep, a polygon too large is safe
    std::array<double, most> x, y;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const std::size_t next = k + 1 == count_ ? 0 : k + 1;
      if (beyond[k] <= 0.0) {
        x[kept] = x_[k];
        y[kept++] = y_[k];
      }
      if ((beyond[k] < 0.0 && beyond[next] > 0.0) || (beyond[k] > 0.0 && beyond[next] < 0.0)) {
        const double share = beyond[k] / (beyond[k] - beyond[next]);
        x[kept] = x_[k] + share * (x_[next] - x_[k]);
        y[kept++] = y_[k] + share * (y_[next] - y_[k]);
      }
    }
    for (std::size_t k = 0; k < kept; ++k) {
      x_[k] = x[k];
      y_[k] = y[k];
    }
    count_ = kept;
  }

 private:
  static constexpr std::size_t most = 24;
  static constexpr double slack = 1e-9;  // [m^2]

  std::array<double, most> x_, y_;
  std::size_t count_;
};

}  // namespace slamicp
