// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>

#include "io/file_bytes.hpp"
#include "io/recording.hpp"
#include "io/ros1_reader.hpp"

namespace slamicp::test {

/// Where legs are by the labels of a bag of angusleigh/leg_tracker (geometry_msgs/PoseArray), one set a scan, in the
/// laser's frame [m].
inline std::vector<PointCloud2> read_leg_labels(const std::filesystem::path& bag) {
  struct Labels : RecordingVisitor {
    int open(const Channel& channel) override { return channel.type == "geometry_msgs/PoseArray" ? 0 : -1; }
    void take(int /*channel*/, double /*logged*/, std::string_view body) override {
      const std::string where = "leg labels";
      ros::Ros1Reader message(body, where);
      message.header();
      PointCloud2& legs = sets.emplace_back();
      for (std::uint32_t left = message.u32(); left > 0; --left) {
        const double x = message.f64();
        const double y = message.f64();
        for (int k = 0; k < 5; ++k) message.f64();  // height and orientation
        legs.emplace_back(x, y);
      }
    }
    void warn(const std::string& /*problem*/) override {}
    std::vector<PointCloud2> sets;
  };
  Labels labels;
  const FileBytes file(bag);
  read_ros1_bag(file.bytes(), bag.string(), labels);
  return labels.sets;
}

}  // namespace slamicp::test
