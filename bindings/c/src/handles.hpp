// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp.h>
#include <vector>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/map/point_map.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/registration/icp.hpp>

/// One of the two.
struct slamicp_map {
  slamicp::PointMap2::Pointer plane;
  slamicp::PointMap3::Pointer space;
};

struct slamicp_icp {
  explicit slamicp_icp(const slamicp::IcpOptions& options) : plane(options), space(options) {}

  slamicp::Icp<2> plane;
  slamicp::Icp<3> space;
  std::vector<slamicp_match> matches;
};

struct slamicp_localizer {
  explicit slamicp_localizer(slamicp::Localizer made) : localizer(std::move(made)) {}

  slamicp::Localizer localizer;
  slamicp::LaserScan scan;  // the last one; keeps its memory
  bool has_scan = false;
  std::vector<slamicp_match> matches;
  std::vector<slamicp::Obstacle> obstacles;
};
