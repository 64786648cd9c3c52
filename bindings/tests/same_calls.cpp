// SPDX-License-Identifier: Apache-2.0
// The calls that Python and Octave make, made in C++ and timed, as a shared library that they load: so both sides of a
// comparison run in one process, in turns (scripts/measure bindings).
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <memory>

#include <slamicp/agent/agent.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/registration/icp.hpp>

namespace {

using namespace slamicp;

struct Scene {
  PointMap2::Pointer map;
  LaserScan scan;
  PointCloud2 points;
  Pose2 pose;
  Localizer localizer;
  Icp<2> icp;
  IcpResult2 result;
  Fix fix;
  std::unique_ptr<Agent> agents[2];
};

template <class Work>
double seconds_each(int times, Work work) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < times; ++k) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) void* prepare(const double* map, std::size_t map_points, const float* ranges,
                                                     std::size_t beams, double angle_min, double angle_increment,
                                                     const double* pose) {
  PointCloud2 cloud;
  for (std::size_t k = 0; k < map_points; ++k) cloud.emplace_back(map[2 * k], map[2 * k + 1]);
  const PointMap2::Pointer snapshot = PointMap2::create(std::move(cloud));
  auto scene = std::make_unique<Scene>(
      Scene{snapshot, {}, {}, {pose[0], pose[1], pose[2]}, Localizer(snapshot), Icp<2>(), {}, {}, {}});
  scene->scan.angle_min = angle_min;
  scene->scan.angle_increment = angle_increment;
  scene->scan.ranges.assign(ranges, ranges + beams);
  scene->points = to_points(scene->scan).in_robot;
  const Point2 here = scene->pose.translation();
  const auto path =
      std::make_shared<const SplinePath>(PointCloud2{here, here + Point2(1.0, 0.0), here + Point2(2.0, 0.0)});
  for (const bool rebuild : {false, true})
    scene->agents[rebuild ? 1 : 0] =
        std::make_unique<Agent>(snapshot, path, AgentOptions{.form = AgentForm::original, .rebuild_index = rebuild});
  return scene.release();
}

/// Localizer::set_pose and update; what Python keeps is a copy of the Fix, so a robot in C++ that keeps its fixes
/// copies it too where `keep` is not 0.
__attribute__((visibility("default"))) double time_update(void* handle, int times, int keep) {
  Scene& scene = *static_cast<Scene*>(handle);
  return seconds_each(times, [&] {
    scene.localizer.set_pose(scene.pose);
    const Fix& fix = scene.localizer.update(scene.scan);
    if (keep != 0) scene.fix = fix;
  });
}

__attribute__((visibility("default"))) double time_align(void* handle, int times) {
  Scene& scene = *static_cast<Scene*>(handle);
  const Outputs wanted{.mean_inlier_distance = true, .outlier_indices = true, .outliers_in_map = true};
  return seconds_each(times, [&] { scene.icp.align(scene.map->indexed(), scene.points, scene.pose, wanted); });
}

/// A control cycle of the paper's original agent (Figure 9a).
__attribute__((visibility("default"))) double time_original_agent(void* handle, int times, int rebuild) {
  Scene& scene = *static_cast<Scene*>(handle);
  Agent& agent = *scene.agents[rebuild != 0 ? 1 : 0];
  return seconds_each(times, [&] {
    agent.set_pose(scene.pose);
    agent.step(scene.scan);
  });
}
}
