// SPDX-License-Identifier: Apache-2.0
#pragma once
// C++17: fronts whose headers know no C++20 include this.

#include <functional>
#include <memory>
#include <slamicp_node/messages.hpp>
#include <slamicp_node/parameters.hpp>
#include <string>

namespace slamicp::node {

/// A localization node without its middleware: messages come in, what is to be published goes out, and time comes in
/// with both. Belongs to one thread; draws on no clock of its own.
///
/// A front hands over each message as it comes and then calls `step` until it gives nothing more; also now and then
/// without a message (every 10 ms or so), for what waits. `step` gives at most one scan's output a call.
class Node {
 public:
  /// Loads the map file, where one is named. Throws slamicp::Error with options.problem(), or where the file cannot be
  /// read.
  /// @param stopwatch        seconds that pass, for the times in Status; none: they stay 0
  /// @param clock_is_played  `now` comes from a recording (use_sim_time)
  explicit Node(const NodeOptions& options, bool clock_is_played = false, std::function<double()> stopwatch = {});
  ~Node();
  Node(Node&&) noexcept;
  Node& operator=(Node&&) noexcept;

  void take_transform(const Transform& transform, bool is_static);
  void take_odometry(const Odometry& odometry, Stamp now);
  /// @param topic  which of scan_topics, from 0
  void take_scan(int topic, const Scan& scan, Stamp now);

  /// The first map, or another one from the next scan on; the pose stays. False, and why, where it cannot be used: then
  /// the old one stays.
  bool take_map(const Grid& grid, std::string& problem);
  /// Where the robot is now. False, and why, where it is of another frame or not finite.
  bool take_pose(const GivenPose& pose, std::string& problem);

  /// Localizes the next scan that waits, if it is ready. Null: nothing to publish. Good until the next call.
  const Output* step(Stamp now);
  /// The last output, for who asks again; null before the first.
  const Output* last() const;

  State state(Stamp now) const;
  Diagnostic diagnostic(Stamp now) const;

  /// The map to publish, where there is a new one: of the map file, and while mapping every `map_update_interval`.
  /// Null: none.
  const Grid* new_map(Stamp now);
  /// Writes the map: `.yaml` as map_server has it, else a cloud by the name's ending. False, and why, where it cannot.
  bool save_map(const std::string& file, std::string& problem) const;

  const NodeOptions& options() const;

 private:
  struct Core;
  std::unique_ptr<Core> core_;
};

}  // namespace slamicp::node
