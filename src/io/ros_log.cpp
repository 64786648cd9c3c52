// SPDX-License-Identifier: Apache-2.0
#include "io/ros_log.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/laser_mount.hpp"
#include "io/log_checks.hpp"
#include "io/median.hpp"
#include "io/ros_recording.hpp"
#include "io/ros_robot.hpp"
#include "io/ros_topics.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

std::string frame_of(const ros::LaserScan& scan) { return std::string(without_slash(scan.header.frame)); }

/// The scans of a topic, each with its laser in its place.
std::vector<LaserScan> placed_scans(RosTopic& topic, const FrameTree& frames, const std::string& base,
                                    const ScanLogOptions& options, std::vector<std::string>& warnings) {
  std::map<std::string, LaserMount> mounts;  // one topic may hold scans of several frames
  std::vector<std::string> doubts;
  std::vector<LaserScan> scans;
  scans.reserve(topic.scans.size());
  for (ros::LaserScan& message : topic.scans) {
    const std::string frame = frame_of(message);
    auto mount = mounts.find(frame);
    if (mount == mounts.end()) mount = mounts.emplace(frame, laser_mount(frames, base, frame, doubts)).first;
    apply(mount->second, message.scan);
    // An offset from the user says where, not which way up.
    if (options.laser_offset) message.scan.T_robot_laser = *options.laser_offset;
    scans.push_back(std::move(message.scan));
  }
  if (!options.laser_offset) warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  topic.scans = {};
  return scans;
}

/// From one scan to the next, the median [s]; 0 of a single scan.
double median_interval(const std::vector<LaserScan>& scans) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < scans.size(); ++i) intervals.push_back(scans[i].stamp - scans[i - 1].stamp);
  return median_of(std::move(intervals));
}

/// A sweep cannot take longer than the time to the next one: drivers that say so say it wrong.
void drop_impossible_beam_times(std::vector<LaserScan>& scans, const std::string& topic,
                                std::vector<std::string>& warnings) {
  constexpr double slack = 1.25;  // stamps jitter
  const double interval = median_interval(scans);
  const double longest = slack * interval;
  const auto is_too_long = [&](const LaserScan& scan) { return !(std::abs(sweep_time(scan)) <= longest); };
  const auto first = std::find_if(scans.begin(), scans.end(), is_too_long);
  if (!(interval > 0.0) || first == scans.end()) return;
  std::string warning = topic + ": a sweep should take ";
  text::append_general(warning, sweep_time(*first), 3);
  warning += " s, but scans come every ";
  text::append_general(warning, interval, 3);
  warnings.push_back(warning + " s: times of single beams are taken as not known");
  for (LaserScan& scan : scans)
    if (is_too_long(scan)) scan.time_increment = 0.0;
}

/// Where the wheels saw the robot at each scan's first beam, and how far it moved until the last.
void add_odometry(const MotionTrack& odometry, std::vector<LaserScan>& scans, std::vector<std::string>& warnings) {
  if (odometry.empty()) return;
  std::size_t missing = 0;
  for (LaserScan& scan : scans)
    if (!set_odometry(odometry, scan)) ++missing;
  if (missing > 0)
    warnings.push_back("odometry does not cover " + std::to_string(missing) + " of " +
                       text::count_of(scans.size(), "scan"));
}

/// Merges by stamps; those of one laser stay in the order they were recorded in.
std::vector<LaserScan> merged(std::vector<std::vector<LaserScan>> lasers) {
  std::vector<std::size_t> next(lasers.size(), 0);
  std::vector<LaserScan> all;
  while (true) {
    std::size_t earliest = lasers.size();
    for (std::size_t laser = 0; laser < lasers.size(); ++laser) {
      if (next[laser] == lasers[laser].size()) continue;
      if (earliest == lasers.size() || lasers[laser][next[laser]].stamp < lasers[earliest][next[earliest]].stamp)
        earliest = laser;
    }
    if (earliest == lasers.size()) return all;
    all.push_back(std::move(lasers[earliest][next[earliest]++]));
    all.back().laser = static_cast<int>(earliest);
  }
}

/// What is no return is each laser's own.
void drop_no_return_constant_of(std::vector<LaserScan>& scans, const std::string& topic, bool is_only,
                                std::vector<std::string>& warnings) {
  ScanLog one;
  one.scans = std::move(scans);
  drop_no_return_constant(one);
  scans = std::move(one.scans);
  const std::string prefix = is_only ? "" : topic + ": ";
  for (std::string& warning : one.warnings) warnings.push_back(warning.insert(0, prefix));
}

}  // namespace

ScanLog make_ros_log(const std::string& name, const std::string& format,
                     const std::function<void(RecordingVisitor&)>& read, const ScanLogOptions& options) {
  require_valid(options);
  RosRecording recording(name, options.scan_topics);
  read(recording);
  const std::vector<RosTopic*> topics = choose_scan_topics(recording, options.scan_topics);

  ScanLog log;
  log.name = name;
  log.format = format;
  log.warnings = recording.warnings();
  for (const RosTopic& topic : recording.topics()) log.messages[told(topic)] += topic.messages;
  if (options.laser_offset && topics.size() > 1)
    log.warnings.push_back("one laser offset is given for " + std::to_string(topics.size()) + " lasers: all sit there");
  const RosRobot robot = find_robot(recording, options, frame_of(topics.front()->scans.front()), log.warnings);
  std::vector<std::vector<LaserScan>> lasers;
  for (RosTopic* const topic : topics) {
    log.lasers.push_back(topic->name);
    lasers.push_back(placed_scans(*topic, recording.frames(), robot.base, options, log.warnings));
    drop_impossible_beam_times(lasers.back(), topic->name, log.warnings);
    drop_no_return_constant_of(lasers.back(), topic->name, topics.size() == 1, log.warnings);
  }
  log.scans = merged(std::move(lasers));
  add_odometry(robot.odometry, log.scans, log.warnings);
  warn_of_backward_stamps(log);
  return log;
}

}  // namespace slamicp
