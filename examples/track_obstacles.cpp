// SPDX-License-Identifier: Apache-2.0
// Follows what a standing robot sees: somebody walks across a hall, a box stands there. Neither is in its map.
#include <cstdio>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

int main() {
  using namespace slamicp;
  World hall;
  const Point2 corners[] = {{0.0, 0.0}, {12.0, 0.0}, {12.0, 8.0}, {0.0, 8.0}};
  for (std::size_t k = 0; k < 4; ++k) hall.walls.push_back({corners[k], corners[(k + 1) % 4]});
  Random random(1);
  const auto map = PointMap2::create(sample_map(hall, random));

  Person somebody;
  somebody.way = {{4.5, 1.5}, {4.5, 6.5}};
  hall.people.push_back(somebody);
  hall = with_box(hall, {{7.0, 2.5}, 0.6, 0.4, 0.3});

  const Pose2 T_map_robot{2.0, 4.0, 0.0};
  const LidarModel lidar = hokuyo_utm30lx();
  Localizer localizer(map);
  localizer.set_pose(T_map_robot);
  ObstacleFinder finder;
  ObstacleTracker tracker;
  int people = 0;
  for (int k = 0; k < 120; ++k) {  // three seconds
    const LaserScan seen = scan(hall, T_map_robot, lidar, random, k / lidar.rate);
    const Fix& fix = localizer.update(seen);
    const auto tracks = tracker.update(fix, seen, finder.find(fix, seen));
    if (k % 20 != 19) continue;
    std::printf("%.2f s\n", seen.stamp);
    people = 0;
    for (const Track& track : tracks) {
      if (track.state == TrackState::tentative) continue;
      std::printf("  %s\n", track.brief().c_str());
      people += track.kind == TrackKind::person ? 1 : 0;
    }
  }
  return people == 1 ? 0 : 1;
}
