// SPDX-License-Identifier: Apache-2.0
// slamicp_ros_drive map FILE | robot | agent: a simulated robot as a ROS robot has it, and an agent that drives it by
// what slamicp_node publishes.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <slamicp_msgs/Obstacles.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>

#include "messages.hpp"
#include "simulated_robot.hpp"

namespace slamicp::drive {
namespace {

/// scan, odom, tf and truth out; cmd_vel in: each command is answered by the next sweep.
class RobotNode {
 public:
  RobotNode() {
    scan_ = handle_.advertise<sensor_msgs::LaserScan>("scan", 100);
    odom_ = handle_.advertise<nav_msgs::Odometry>("odom", 100);
    tf_ = handle_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    static_tf_ = handle_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    truth_ = handle_.advertise<geometry_msgs::PoseStamped>("truth", 100);
    const boost::function<void(const geometry_msgs::Twist::ConstPtr&)> obey =
        [this](const geometry_msgs::Twist::ConstPtr& twist) {
          command_ = {twist->linear.x, twist->linear.y, twist->angular.z};
          step();
        };
    command_subscriber_ =
        handle_.subscribe<geometry_msgs::Twist>("cmd_vel", 10, obey, {}, ros::TransportHints().tcpNoDelay());
    service_ = handle_.advertiseService("remove_box", &RobotNode::remove_box, this);
    const boost::function<void(const ros::WallTimerEvent&)> look = [this](const ros::WallTimerEvent&) {
      if (ros::WallTime::now() - last_ < ros::WallDuration(0.5) || scan_.getNumSubscribers() == 0) return;
      command_ = {};
      step();
    };
    timer_ = handle_.createWallTimer(ros::WallDuration(0.1), look);
    tf2_msgs::TFMessage mount;
    mount.transforms.push_back(transform(0.0, "base_link", "laser", {}));
    static_tf_.publish(mount);
  }

 private:
  void step() {
    last_ = ros::WallTime::now();
    const Sweep& sweep = robot_.step(command_);
    const tf2_msgs::TFMessage wheels = wheels_of(sweep);
    tf_.publish(wheels);
    nav_msgs::Odometry odometry;
    odometry.header = wheels.transforms[0].header;
    odometry.child_frame_id = "base_link";
    odometry.pose.pose.position.x = sweep.odometry.x;
    odometry.pose.pose.position.y = sweep.odometry.y;
    odometry.pose.pose.orientation = turn_by(sweep.odometry.theta);
    odom_.publish(odometry);
    geometry_msgs::PoseStamped truth;
    truth.header.stamp = odometry.header.stamp;
    truth.header.frame_id = "map";
    truth.pose.position.x = sweep.truth.x;
    truth.pose.position.y = sweep.truth.y;
    truth.pose.orientation = turn_by(sweep.truth.theta);
    truth_.publish(truth);
    const sensor_msgs::LaserScan scan = scan_of(sweep);
    scan_.publish(scan);
  }

  bool remove_box(std_srvs::Empty::Request& /*request*/, std_srvs::Empty::Response& /*response*/) {
    robot_.remove_box();
    return true;
  }

  ros::NodeHandle handle_;
  SimulatedRobot robot_;
  Command command_;
  ros::WallTime last_;
  ros::Publisher scan_, odom_, tf_, static_tf_, truth_;
  ros::Subscriber command_subscriber_;
  ros::ServiceServer service_;
  ros::WallTimer timer_;
};

/// amcl_pose and obstacles in, cmd_vel out.
class AgentNode {
 public:
  AgentNode() {
    command_ = handle_.advertise<geometry_msgs::Twist>("cmd_vel", 10);
    travelled_ = handle_.advertise<std_msgs::Float64>("travelled", 100);
    const auto promptly = ros::TransportHints().tcpNoDelay();
    const boost::function<void(const slamicp_msgs::Obstacles::ConstPtr&)> take =
        [this](const slamicp_msgs::Obstacles::ConstPtr& message) {
          things_.clear();
          for (const slamicp_msgs::Obstacle& each : message->obstacles)
            if (each.state != "tentative") things_.push_back({each.x, each.y, 0.5 * each.width});
        };
    obstacles_ = handle_.subscribe<slamicp_msgs::Obstacles>("obstacles", 10, take, {}, promptly);
    const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr&)> drive =
        [this](const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& message) {
          const auto& pose = message->pose.pose;
          const Command command = follower_.follow(
              message->header.stamp.toSec(),
              {pose.position.x, pose.position.y, 2.0 * std::atan2(pose.orientation.z, pose.orientation.w)}, things_);
          geometry_msgs::Twist twist;
          twist.linear.x = command.x;
          twist.linear.y = command.y;
          twist.angular.z = command.turn;
          command_.publish(twist);
          std_msgs::Float64 way;
          way.data = follower_.travelled();
          travelled_.publish(way);
        };
    pose_ = handle_.subscribe<geometry_msgs::PoseWithCovarianceStamped>("amcl_pose", 10, drive, {}, promptly);
  }

 private:
  ros::NodeHandle handle_;
  Follower follower_;
  std::vector<Thing> things_;
  ros::Publisher command_, travelled_;
  ros::Subscriber obstacles_, pose_;
};

}  // namespace
}  // namespace slamicp::drive

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "map") == 0) {
    const slamicp::drive::PlainPose start = slamicp::drive::SimulatedRobot::write_map(argv[2]);
    std::printf("%.9f %.9f %.9f\n", start.x, start.y, start.theta);
    return 0;
  }
  const bool is_robot = argc > 1 && std::strcmp(argv[1], "robot") == 0;
  if (!is_robot && (argc < 2 || std::strcmp(argv[1], "agent") != 0)) return 2;
  ros::init(argc, argv, is_robot ? "simulated_robot" : "agent");
  ros::NodeHandle handle;
  if (is_robot) {
    const slamicp::drive::RobotNode robot;
    ros::spin();
  } else {
    const slamicp::drive::AgentNode agent;
    ros::spin();
  }
  return 0;
}
