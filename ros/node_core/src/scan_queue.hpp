// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <slamicp_node/messages.hpp>
#include <string>
#include <vector>

#include <slamicp/scan/laser_scan.hpp>

namespace slamicp::node {

/// A scan that waits for its turn.
struct WaitingScan {
  Stamp stamp;
  std::string frame;
  double arrived = 0.0;  ///< in the node's clock [s]
  LaserScan scan;
};

/// Scans of all lasers by their stamps, and what is wrong with them.
class ScanQueue {
 public:
  explicit ScanQueue(std::size_t topics) : topics_(topics) {}

  enum class Taken {
    yes,
    late,    ///< not after the last one of its topic: left out
    broken,  ///< no stamp, no direction: left out
    again,   ///< taken; its topic's stamps went back by more than a second: time begins again
  };
  Taken add(int topic, const Scan& message, double now);

  bool empty() const noexcept { return waiting_.empty(); }
  WaitingScan& front() noexcept { return waiting_.front(); }
  void pop();
  void clear();
  /// The node's clock was set: who waits arrives now.
  void arrive_again(double now) noexcept;

  std::uint64_t taken() const noexcept { return taken_; }
  /// Late, broken or too many at once.
  std::uint64_t dropped() const noexcept { return dropped_; }
  /// Times that a laser changed its beams.
  std::uint64_t changes() const noexcept { return changes_; }

 private:
  struct Topic {
    bool heard = false;
    Stamp last;
    double interval = 0.0;  // between its scans, at least [s]; 0: not known
    std::size_t beams = 0;
    float angle_min = 0.0F, angle_increment = 0.0F;
  };
  Taken judge(Topic& topic, const Scan& message);
  void convert(const Topic& topic, const Scan& message, LaserScan& scan) const;

  std::vector<Topic> topics_;
  std::deque<WaitingScan> waiting_;
  std::vector<WaitingScan> spare_;  // their memory is used again
  std::uint64_t taken_ = 0, dropped_ = 0, changes_ = 0;
};

}  // namespace slamicp::node
