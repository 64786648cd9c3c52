// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// What ROS 1 bags, rosbag2 and MCAP have in common: messages of typed topics, in the order they were recorded.
namespace slamicp {

enum class Serialization {
  ros1,  ///< fields one after the other, little endian
  cdr,   ///< OMG CDR, as DDS and ROS 2 have it: an encapsulation header, then aligned fields
};

/// A topic as a recording names it.
struct Channel {
  std::string topic;  ///< "/scan"
  std::string type;   ///< "sensor_msgs/LaserScan", for ROS 2 too
  Serialization serialization = Serialization::ros1;
};

/// Takes what a recording holds, message by message. It may throw Error to stop the reading.
class RecordingVisitor {
 public:
  virtual ~RecordingVisitor() = default;

  /// Called before a channel's first message, and for channels without one where the recording lists them. More than
  /// one channel may have the same topic.
  /// @return a number that `take` gets with each of the channel's messages; negative: they are not wanted, and need
  ///         not be unpacked
  virtual int open(const Channel& channel) = 0;

  /// @param logged  when it was recorded [s]
  /// @param body  the message as serialized, good during the call only
  virtual void take(int channel, double logged, std::string_view body) = 0;

  /// A problem that does not stop the reading, in words.
  virtual void warn(const std::string& problem) = 0;
};

/// Each reads one container; `name` is the file's, for messages. A recording that was cut gives what came whole, and a
/// warning; Error where nothing can be had of it.
void read_ros1_bag(std::string_view bytes, const std::string& name, RecordingVisitor& visitor);
void read_mcap(std::string_view bytes, const std::string& name, RecordingVisitor& visitor);
/// @param path  a `.db3` file, or a rosbag2 folder: its metadata.yaml names `.db3` or `.mcap` files
void read_rosbag2(const std::filesystem::path& path, RecordingVisitor& visitor);

}  // namespace slamicp
