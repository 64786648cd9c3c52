// SPDX-License-Identifier: Apache-2.0
// slamicp_dds_load start       where the robot starts in the map of `slamicp_dds_peer map FILE`: x y theta
// slamicp_dds_load SECONDS     its scans at 40 Hz, with somebody who listens to all of the node's topics; from when a
//                              scan is written until its pose has come
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>

#include "expect.hpp"
#include "robot.hpp"
#include "room.hpp"

namespace slamicp::dds_peer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double hertz = 40.0;

/// Round and round in the room, with what the map does not have beside the way.
SimulatedRun rounds(double seconds) {
  World world = node::room();
  world.pillars.push_back({{6.0, 4.0}, 0.2});
  DriveOptions options;
  options.speed = 0.5;
  options.lidar.rate = hertz;
  constexpr int waypoints_a_round = 12;
  constexpr double way_round = 2.0 * std::numbers::pi * 1.5;  // at least [m]
  const int waypoints = 3 + static_cast<int>(seconds * options.speed / way_round * waypoints_a_round);
  std::vector<Point2> way;
  for (int k = 0; k < waypoints; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / waypoints_a_round;
    way.emplace_back(6.0 + 2.5 * std::cos(angle), 4.0 + 1.5 * std::sin(angle));
  }
  SimulatedRun run = simulate_drive(world, way, options);
  for (LaserScan& scan : run.scans) scan.stamp += 1000.0;
  return run;
}

class Load {
 public:
  explicit Load(double seconds) : run_(rounds(seconds)), scans_(static_cast<std::size_t>(seconds * hertz)) {
    must(run_.scans.size() >= scans_, "the way is too short");
    mount_.write(transforms_message({transform(0.0, "base_link", "laser", {})}));
  }

  void run() {
    wait_for([&] { return scan_.is_heard() && tf_.is_heard() && pose_.speakers() > 0; }, "all topics");
    std::this_thread::sleep_for(std::chrono::seconds(1));
    std::thread ear([&] {
      while (hear()) {
      }
    });
    const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / hertz));
    Clock::time_point next = Clock::now();
    for (std::size_t k = 0; k < scans_; ++k, next += period) send(run_.scans[k], next);
    ear.join();
    tell();
  }

 private:
  /// Odometry a period before the scan, as wheels that are read more often have it; then the scan, at its time.
  void send(const LaserScan& scan, Clock::time_point when) {
    const double end = scan.stamp + sweep_time(scan) + 1e-3;
    const Pose2 T_odom_end = *scan.T_odom_robot * scan.sweep_motion.value_or(Pose2());
    tf_.write(transforms_message({transform(scan.stamp, "odom", "base_link", *scan.T_odom_robot),
                                  transform(end, "odom", "base_link", T_odom_end)}));
    const node::Scan message = message_of(scan, {"scan", "laser"});
    const Bytes bytes = scan_message(message);
    std::this_thread::sleep_until(when);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      sent_[message.stamp.nanoseconds] = Clock::now();
    }
    scan_.write(bytes);
  }

  /// The next poses; false: none has come for two seconds.
  bool hear() {
    if (!pose_.wait(2.0)) return false;
    const Clock::time_point now = Clock::now();
    Bytes bytes;
    while (pose_.take(bytes)) {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto sent = sent_.find(read_pose(bytes).stamp.nanoseconds);
      if (sent == sent_.end()) continue;
      latencies_.push_back(std::chrono::duration<double>(now - sent->second).count());
      sent_.erase(sent);
    }
    return true;
  }

  void tell() {
    std::sort(latencies_.begin(), latencies_.end());
    must(!latencies_.empty(), "no pose came");
    const auto quantile = [&](double share) {
      return 1e3 * latencies_[static_cast<std::size_t>(share * static_cast<double>(latencies_.size() - 1))];
    };
    std::printf("scans %zu, poses %zu, scan to pose [ms]: median %.3f, p90 %.3f, p99 %.3f, p99.9 %.3f, max %.3f\n",
                scans_, latencies_.size(), quantile(0.5), quantile(0.9), quantile(0.99), quantile(0.999),
                quantile(1.0));
  }

  FastDds::Reader listener(const std::string& topic, const std::string& type) {
    return dds_.reader("rt/" + topic, type, {true, false, 1});
  }

  SimulatedRun run_;
  std::size_t scans_;
  std::mutex mutex_;
  std::map<std::int64_t, Clock::time_point> sent_;
  std::vector<double> latencies_;

  FastDds dds_{domain()};
  FastDds::Writer mount_ = dds_.writer("rt/tf_static", "tf2_msgs::msg::dds_::TFMessage_", {true, true, 1});
  FastDds::Writer tf_ = dds_.writer("rt/tf", "tf2_msgs::msg::dds_::TFMessage_", {true, false, 100});
  FastDds::Writer scan_ = dds_.writer("rt/scan", "sensor_msgs::msg::dds_::LaserScan_", {false, false, 5});
  FastDds::Reader pose_ =
      dds_.reader("rt/amcl_pose", "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_", {true, true, 100});
  FastDds::Reader others_[5] = {listener("outliers", "sensor_msgs::msg::dds_::PointCloud2_"),
                                listener("inliers", "sensor_msgs::msg::dds_::PointCloud2_"),
                                listener("obstacles", "slamicp_msgs::msg::dds_::Obstacles_"),
                                listener("obstacle_markers", "visualization_msgs::msg::dds_::MarkerArray_"),
                                listener("slamicp/status", "slamicp_msgs::msg::dds_::Status_")};
};

int run(int argc, char** argv) {
  if (argc != 2) return 2;
  if (std::string(argv[1]) == "start") {
    const Pose2 pose = rounds(0.0).truth.front().pose;
    std::printf("%.17g %.17g %.17g\n", pose.x, pose.y, pose.theta);
    return 0;
  }
  Load(std::atof(argv[1])).run();
  return 0;
}

}  // namespace
}  // namespace slamicp::dds_peer

int main(int argc, char** argv) {
  return slamicp::dds_peer::tell_problems([&] { return slamicp::dds_peer::run(argc, argv); });
}
