// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <slamicp_node/node.hpp>
#include <string>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/map/grid_builder.hpp>
#include <slamicp/mapping/mapper.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>

#include "frames.hpp"
#include "scan_queue.hpp"
#include "wheels.hpp"

namespace slamicp::node {

struct Node::Core {
  Core(const NodeOptions& chosen, bool played, std::function<double()> watch);

  bool is_mapping() const noexcept { return options.mode == "mapping"; }
  double time() const { return stopwatch ? stopwatch() : 0.0; }

  /// Time goes on, or was set.
  void note_clock(double now);
  /// Stamps went back: a recording that begins again, or a clock that was set.
  void begin_again(double stamp);
  void use_map(PointMap2::Pointer map);
  void set_pose(const Pose2& pose);

  /// Whether the scan can be localized now; else it waits, or its time is up.
  enum class Ready { yes, wait, give_up };
  Ready ready(const WaitingScan& waiting, double now);
  void localize(WaitingScan& waiting, double now);
  void map_it(WaitingScan& waiting);
  void find_transform(const WaitingScan& waiting, const Pose2& T_map_base);
  void set_odometry_of(LaserScan& scan);

  NodeOptions options;
  bool clock_is_played;
  std::function<double()> stopwatch;

  Frames frames;
  Wheels wheels;
  FrozenWheels frozen;
  ScanQueue queue;
  std::optional<Localizer> localizer;  // from the first map on
  std::optional<Mapper> mapper;        // while mapping
  GridBuilder builder;
  ObstacleFinder finder;
  ObstacleTracker tracker;

  Pose2 start;                       // where a recording begins
  bool has_pose;                     // false: waits for it
  bool localized = false;            // a scan, since it started
  Pose3 T_base_laser;                // of the scan at hand
  std::uint64_t odometry_jumps = 0;  // as the localizer knows them
  double clock = 0.0;                // the latest `now` [s]
  bool clock_set = false;
  bool clock_went_back = false;  // since the last scan
  double last_scan = 0.0;        // when one came [s]
  bool heard_scan = false;
  std::string missing_frame;  // the laser that sits nowhere; empty: none
  std::uint64_t without_map = 0, without_frame = 0, without_odometry = 0, restarts = 0, maps = 0, recoveries = 0;
  bool waits_for_odometry = false;
  bool mapping_is_over = false;  // its recording began again

  Output output;
  bool has_output = false;

  Grid grid;  // the map as it was published or came
  bool has_grid = false, grid_is_new = false;
  int keyframes = 0;  // that are in the builder
  int published_keyframes = 0;
  double next_map = 0.0;
};

LocalizerOptions localizer_options(const NodeOptions& options);
MapperOptions mapper_options(const NodeOptions& options);

}  // namespace slamicp::node
