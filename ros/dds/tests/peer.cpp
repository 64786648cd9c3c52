// SPDX-License-Identifier: Apache-2.0
// slamicp_dds_peer WHAT: a simulated robot that speaks Fast DDS, in ROS_DOMAIN_ID.
//   start      where the robot starts in the map: x y theta
//   map FILE   writes the map
//   tf         gives map, tf and scans, and hears what slamicp_dds says of them
//   odom FILE  gives the clock, odometry, a first pose and scans in namespace /robot; the node has the map FILE
//   lasers     as tf, with two lasers
//   amcl       as tf; the node has amcl's name and the parameters of dds_test.py's file for nav2's
//   mapping    as tf, without a map: hears the one that the node makes
//   lesser     gives tf and a map with less than ROS 2 gives: the node must not hear them
// All but the last hold every word of the node against slamicp::node_core in this process, which is given the same
// messages.
#include <cstdio>
#include <stdexcept>

#include <slamicp/io/map_file.hpp>

#include "expect.hpp"
#include "robot.hpp"

namespace slamicp::dds_peer {
namespace {

/// The node must go on waiting for a map that is offered all the time, but to those alone who were there before.
void offer_less() {
  FastDds dds(domain());
  const FastDds::Writer tf = dds.writer("rt/tf", "tf2_msgs::msg::dds_::TFMessage_", {false, false, 10});
  const FastDds::Writer map = dds.writer("rt/map", "nav_msgs::msg::dds_::OccupancyGrid_", {true, false, 1});
  const FastDds::Reader status =
      dds.reader("rt/slamicp/status", "slamicp_msgs::msg::dds_::Status_", {true, false, 200});
  for (int heard = 0; heard < 2; ++heard) {
    Bytes bytes;
    wait_for(
        [&] {
          map.write(grid_message(map_grid()));
          return status.take(bytes);
        },
        "status");
    must(read_status(bytes).state == "waiting_for_map", read_status(bytes).state);
  }
  must(!tf.is_heard() && !map.is_heard(), "the node hears what promises less than it asks for");
}

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "start") {
    const Pose2 pose = drive().truth.front().pose;
    std::printf("%.17g %.17g %.17g\n", pose.x, pose.y, pose.theta);
  } else if (what == "map" && argc == 3) {
    save_map(argv[2], *PointMap2::create(wall_samples()));
  } else if (what == "tf") {
    Robot({.scans = 100}).drive_and_compare();
  } else if (what == "odom" && argc == 3) {
    Robot({.scans = 100, .odometry_map = argv[2], .name = "localization"}).drive_and_compare();
  } else if (what == "lasers") {
    Robot({.lasers = {{"front", "laser"}, {"back", "laser_behind", 2.5}}}).drive_and_compare();
  } else if (what == "amcl") {
    Robot({.name = "amcl", .transform_tolerance = 1.0, .laser_max_range = 100.0}).drive_and_compare();
  } else if (what == "mapping") {
    Robot({.is_mapping = true}).drive_and_compare();
  } else if (what == "lesser") {
    offer_less();
  } else {
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace slamicp::dds_peer

int main(int argc, char** argv) {
  return slamicp::dds_peer::tell_problems([&] { return slamicp::dds_peer::run(argc, argv); });
}
