// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/registration/icp_options.hpp>

namespace slamicp {

/// The solver's gate: wide while the pose is far off, then down to where only the wall itself is left.
class Gate {
 public:
  /// @param first  where it starts [m]
  Gate(const IcpOptions& options, double map_spacing, double first) noexcept
      : gate_(first),
        final_(options.final_gate > 0.0
                   ? options.final_gate
                   : std::min(options.max_correspondence_distance, std::max(smallest, spacings * map_spacing))) {}

  double value() const noexcept { return gate_; }
  bool is_final() const noexcept { return gate_ <= final_; }
  double last() const noexcept { return final_; }

  /// @param left  how far the scan's points may still have to move [m]
  void shrink(double left) noexcept {
    gate_ = std::max(final_, std::min(gate_, std::max(shrinkage * gate_, 3.0 * left)));
  }

 private:
  static constexpr double smallest = 0.05;  // [m], the noise of a lidar and a wall as thick as maps have them
  static constexpr double spacings = 2.5;   // of the map's points, so that a thin map is not torn from the scan
  static constexpr double shrinkage = 0.5;

  double gate_;
  double final_;
};

/// Which share of the scan a step looks at: few points while the pose is far off, all of them at the end. A cloud may
/// take turns between two, three or four walls; its every fifth or seventh point still shows them all.
class Stride {
 public:
  explicit Stride(std::size_t points) noexcept {
    if (points > coarse * enough)
      value_ = coarse;
    else if (points > medium * enough)
      value_ = medium;
  }

  std::size_t value() const noexcept { return value_; }
  bool is_final() const noexcept { return value_ == 1; }

  /// @param moved  how far the last step moved the scan's points [m]
  void refine(double moved) noexcept {
    if (moved < 0.02 && value_ > medium)
      value_ = medium;
    else if (moved < 0.01)
      value_ = 1;
  }

 private:
  static constexpr std::size_t coarse = 7;
  static constexpr std::size_t medium = 5;
  static constexpr std::size_t enough = 100;  // points, for a step that can be trusted

  std::size_t value_ = 1;
};

/// Watches the steps: how much motion is left, and whether it is little enough to stop.
template <int D>
class Convergence {
 public:
  Convergence(const IcpOptions& options, const Pose<D>& guess) noexcept
      : translation_(options.translation_tolerance), rotation_(options.rotation_tolerance), now_(guess), mark_(guess) {}

  /// @param pose  after another step
  void step_to(const Pose<D>& pose) noexcept {
    const double step = size_of(distance(now_, pose));
    if (last_ > 0.0) ratio_ = std::min(step / last_, 0.999);
    now_ = pose;
    last_ = step;
    watch_for_cycles();
  }

  /// Steps that shrink by a ratio q leave q / (1 - q) of the last one to go; those of a cycle lead nowhere.
  double left_of_last_step() const noexcept { return is_cycle_ ? 0.0 : ratio_ / (1.0 - ratio_); }
  bool reached() const noexcept { return is_cycle_ || last_ * left_of_last_step() < 1.0; }

 private:
  /// A match may go round for ever between some sets of pairs, and more steps bring nothing. Brent 1980 ("An improved
  /// Monte Carlo factorization algorithm"): a mark that moves on after 1, 2, 4, ... steps; who meets it goes round.
  void watch_for_cycles() noexcept {
    ++since_mark_;
    is_cycle_ = since_mark_ > 1 && size_of(distance(mark_, now_)) < 0.1;
    if (since_mark_ < next_mark_) return;
    mark_ = now_;
    since_mark_ = 0;
    next_mark_ *= 2;
  }

  double size_of(const PoseDistance& moved) const noexcept {
    return std::max(moved.translation / translation_, moved.rotation / rotation_);
  }

  double translation_;
  double rotation_;
  double ratio_ = 0.5;  // what steps shrink by; a guess until two of them tell
  Pose<D> now_;
  double last_ = 0.0;  // the last step, in tolerances
  Pose<D> mark_;
  int since_mark_ = 0;  // steps
  int next_mark_ = 2;   // after so many
  bool is_cycle_ = false;
};

}  // namespace slamicp
