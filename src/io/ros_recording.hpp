// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <slamicp/io/scan_log.hpp>
#include <slamicp/scan/motion_track.hpp>

#include "io/frame_tree.hpp"
#include "io/recording.hpp"
#include "io/ros_messages.hpp"

namespace slamicp {

/// A topic of a recording, and what it held of use.
struct RosTopic {
  enum class Kind { scan, odometry, tf, other };

  std::string name, type;
  Kind kind = Kind::other;
  std::size_t messages = 0;
  std::size_t broken = 0;     ///< messages left out
  std::string problem;        ///< of the first of them
  std::size_t unstamped = 0;  ///< messages that got the stamp of their recording

  std::vector<ros::LaserScan> scans;
  std::vector<MotionTrack::Sample> odometry;
  std::string odometry_child;  ///< the frame that the odometry is of
};

/// Keeps of a recording what a log of scans needs: scans, odometry and tf; of other topics, how many messages.
class RosRecording : public RecordingVisitor {
 public:
  /// @param scan_topics  scans to keep; empty: all
  RosRecording(std::string name, const std::vector<std::string>& scan_topics);

  int open(const Channel& channel) override;
  void take(int channel, double logged, std::string_view body) override;
  void warn(const std::string& problem) override { warnings_.push_back(problem); }

  const std::string& name() const noexcept { return name_; }
  std::vector<RosTopic>& topics() noexcept { return topics_; }
  const std::vector<RosTopic>& topics() const noexcept { return topics_; }
  const FrameTree& frames() const noexcept { return frames_; }
  /// The container's problems, and those of the messages.
  std::vector<std::string> warnings() const;

 private:
  struct OpenChannel {
    std::size_t topic;
    Serialization serialization;
    bool is_wanted;
  };
  void decode(RosTopic& topic, Serialization serialization, double logged, std::string_view body);

  std::string name_;
  std::vector<std::string> scan_topics_;
  std::vector<RosTopic> topics_;  ///< in the order of their first appearance
  std::map<std::pair<std::string, std::string>, std::size_t> topic_of_;
  std::vector<OpenChannel> channels_;
  FrameTree frames_;
  std::vector<std::string> warnings_;
};

/// True where both name one topic or frame, with or without a leading slash.
inline bool same_name(std::string_view a, std::string_view b) noexcept { return without_slash(a) == without_slash(b); }

}  // namespace slamicp
