// SPDX-License-Identifier: Apache-2.0
// slamicp_ros_load SECONDS: a robot's scans at 40 Hz, with somebody who listens to all of the node's topics; from when
// a scan is published until its pose is received.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <map>
#include <mutex>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <slamicp_msgs/Obstacles.h>
#include <slamicp_msgs/Status.h>
#include <tf2_msgs/TFMessage.h>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

#include "messages.hpp"
#include "simulated_robot.hpp"

namespace slamicp::drive {
namespace {

using SteadyClock = std::chrono::steady_clock;

class Load {
 public:
  Load() {
    scan_ = handle_.advertise<sensor_msgs::LaserScan>("scan", 100);
    tf_ = handle_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    static_tf_ = handle_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    tf2_msgs::TFMessage mount;
    mount.transforms.push_back(transform(0.0, "base_link", "laser", {}));
    static_tf_.publish(mount);
    listen<sensor_msgs::PointCloud2>("outliers");
    listen<sensor_msgs::PointCloud2>("inliers");
    listen<slamicp_msgs::Obstacles>("obstacles");
    listen<visualization_msgs::MarkerArray>("obstacle_markers");
    listen<slamicp_msgs::Status>("slamicp/status");
    const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr&)> take =
        [this](const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& pose) {
          const SteadyClock::time_point now = SteadyClock::now();
          const std::lock_guard<std::mutex> lock(mutex_);
          const auto sent = sent_.find(pose->header.stamp.toNSec());
          if (sent != sent_.end()) latencies_.push_back(std::chrono::duration<double>(now - sent->second).count());
        };
    subscribers_.push_back(handle_.subscribe<geometry_msgs::PoseWithCovarianceStamped>(
        "amcl_pose", 100, take, {}, ros::TransportHints().tcpNoDelay()));
  }

  void run(double seconds) {
    constexpr double hertz = 40.0;
    robot_.rate = hertz;
    while (ros::ok() && scan_.getNumSubscribers() == 0) ros::WallDuration(0.05).sleep();
    ros::WallDuration(1.0).sleep();
    SteadyClock::time_point next = SteadyClock::now();
    const auto period = std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(1.0 / hertz));
    const int scans = static_cast<int>(seconds * hertz);
    for (int k = 0; k < scans && ros::ok(); ++k) {
      send(k == 0 ? robot_.step({}) : robot_.step(robot_.wander()), next);
      next += period;
    }
    ros::WallDuration(1.0).sleep();
    tell(scans);
  }

 private:
  template <class Message>
  void listen(const char* topic) {
    const boost::function<void(const typename Message::ConstPtr&)> hear = [](const typename Message::ConstPtr&) {};
    subscribers_.push_back(handle_.subscribe<Message>(topic, 100, hear));
  }

  /// Odometry half a sweep before the scan, as wheels that are read more often have it; then the scan, at its time.
  void send(const Sweep& sweep, SteadyClock::time_point when) {
    const tf2_msgs::TFMessage wheels = wheels_of(sweep);
    const sensor_msgs::LaserScan scan = scan_of(sweep);
    tf_.publish(wheels);
    const auto wait = std::chrono::duration<double>(when - SteadyClock::now()).count();
    if (wait > 0.0) ros::WallDuration(wait).sleep();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      sent_[scan.header.stamp.toNSec()] = SteadyClock::now();
    }
    scan_.publish(scan);
  }

  void tell(int scans) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::sort(latencies_.begin(), latencies_.end());
    if (latencies_.empty()) {
      std::puts("no pose came");
      return;
    }
    const auto quantile = [&](double share) {
      return 1e3 * latencies_[static_cast<std::size_t>(share * static_cast<double>(latencies_.size() - 1))];
    };
    std::printf("scans %d, poses %zu, scan to pose [ms]: median %.3f, p90 %.3f, p99 %.3f, p99.9 %.3f, max %.3f\n",
                scans, latencies_.size(), quantile(0.5), quantile(0.9), quantile(0.99), quantile(0.999), quantile(1.0));
  }

  ros::NodeHandle handle_;
  SimulatedRobot robot_;
  ros::Publisher scan_, tf_, static_tf_;
  std::vector<ros::Subscriber> subscribers_;
  std::mutex mutex_;
  std::map<std::uint64_t, SteadyClock::time_point> sent_;
  std::vector<double> latencies_;
};

}  // namespace
}  // namespace slamicp::drive

int main(int argc, char** argv) {
  ros::init(argc, argv, "load");
  ros::NodeHandle handle;
  ros::AsyncSpinner spinner(1);
  slamicp::drive::Load load;
  spinner.start();
  load.run(argc > 1 ? std::atof(argv[1]) : 60.0);
  return 0;
}
