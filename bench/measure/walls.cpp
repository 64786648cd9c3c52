// SPDX-License-Identifier: Apache-2.0
// wall thickness and map points per metre of wall on FR079, mapped from outliers only and from all points, with
// pictures
//
// scripts/measure walls [--scans N]     the first N scans only, for a quick look
#include <Eigen/Eigenvalues>

#include <slamicp/evaluation/relation_error.hpp>
#include <slamicp/geometry/voxel_grid.hpp>
#include <slamicp/io/relations_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/mapper.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

constexpr double reach = 0.25;      // [m] looked at around a place, along the wall and across
constexpr double place_size = 0.1;  // [m] one place for each square of this size that holds map points
constexpr double elongation = 0.3;  // a place is a wall if its points' spread across is below this share of that along
constexpr std::size_t fewest = 10;  // points that tell a wall

/// A place on a wall, and the wall's normal there.
struct Place {
  Point2 centre;
  Point2 normal;
};

std::vector<int> points_around(const KdTree<2>& tree, const Point2& centre) {
  std::vector<int> around;
  tree.within(centre, reach, around);
  return around;
}

/// Where the map shows a wall: one place for each square that holds points, if the points around it lie along a line.
std::vector<Place> wall_places(const PointCloud2& map) {
  const KdTree<2> tree(map);
  std::vector<Place> places;
  for (const Point2& centre : voxel_downsampled<2>(map, place_size)) {
    const std::vector<int> around = points_around(tree, centre);
    if (around.size() < fewest) continue;
    const auto count = static_cast<double>(around.size());
    Point2 mean = Point2::Zero();
    for (const int k : around) mean += (map[static_cast<std::size_t>(k)] - centre) / count;
    Matrix<2, 2> scatter = Matrix<2, 2>::Zero();
    for (const int k : around) {
      const Point2 offset = map[static_cast<std::size_t>(k)] - centre - mean;
      scatter += offset * offset.transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(scatter);
    const double across = std::sqrt(std::max(0.0, eigen.eigenvalues()[0]));
    if (across < elongation * std::sqrt(eigen.eigenvalues()[1]))
      places.push_back({centre, eigen.eigenvectors().col(0)});
  }
  return places;
}

/// What a map is like at these places.
struct Walls {
  std::vector<double> thickness;         // [m] twice the standard deviation across; only with three points or more
  std::vector<double> extent;            // [m] from the first point across to the last; the same
  std::vector<double> points_per_metre;  // at every place
};

Walls walls_of(const PointCloud2& map, const std::vector<Place>& places) {
  const KdTree<2> tree(map);
  Walls walls;
  for (const Place& place : places) {
    const std::vector<int> around = points_around(tree, place.centre);
    walls.points_per_metre.push_back(static_cast<double>(around.size()) / (2.0 * reach));
    if (around.size() < 3) continue;
    std::vector<double> across;
    across.reserve(around.size());
    for (const int k : around) across.push_back(place.normal.dot(map[static_cast<std::size_t>(k)] - place.centre));
    const double middle = mean(across);
    double square = 0.0;
    for (const double offset : across) square += (offset - middle) * (offset - middle);
    walls.thickness.push_back(2.0 * std::sqrt(square / static_cast<double>(across.size())));
    const auto [least, most] = std::minmax_element(across.begin(), across.end());
    walls.extent.push_back(*most - *least);
  }
  return walls;
}

struct Mapped {
  std::string name;
  PointCloud2 map;
  Trajectory trajectory;
  double seconds = 0.0;
};

Mapper run_mapper(const MapperOptions& options, const ScanLog& log, std::size_t scans) {
  Mapper mapper(options);
  for (std::size_t k = 0; k < scans; ++k) mapper.add(log[k]);
  return mapper;
}

/// The 10 m x 10 m on the robot's way that hold most map points.
Bounds<2> busiest_place(const Mapped& mapped) {
  Point2 best = Point2::Zero();
  std::ptrdiff_t most = -1;
  for (std::size_t k = 0; k < mapped.trajectory.size(); k += 20) {
    const Point2 centre = mapped.trajectory[k].pose.translation();
    const auto inside = [&](const Point2& point) { return (point - centre).lpNorm<Eigen::Infinity>() < 5.0; };
    const std::ptrdiff_t count = std::count_if(mapped.map.begin(), mapped.map.end(), inside);
    if (count <= most) continue;
    most = count;
    best = centre;
  }
  return {best - Point2(5.0, 5.0), best + Point2(5.0, 5.0)};
}

void draw(const std::string& file, const Mapped& mapped, const Bounds<2>& detail) {
  const std::string legend = std::to_string(mapped.map.size()) + " map points";
  PictureOptions options;
  options.title = "FR079, " + mapped.name;
  Picture whole(options);
  whole.points(mapped.map, colours::map, 0.7, legend).path(mapped.trajectory, colours::robot, 0.8, "path");
  save_picture(file, whole);
  options.title += ", 10 m x 10 m of it";
  options.bounds = detail;
  Picture part(options);
  part.points(mapped.map, colours::map, 1.1, legend + " in all");
  save_picture(file + "_detail", part);
}

/// As grown from outliers (first), refined as `slamicp map` writes it (second), with other distances, from all points
/// (last).
std::vector<Mapped> build_maps(const ScanLog& log, std::size_t scans) {
  std::vector<Mapped> maps;
  const double usual = MapperOptions{}.insertion_distance;
  for (const double distance : {usual, 0.1, 0.3}) {
    MapperOptions options;
    options.insertion_distance = distance;
    const Stopwatch watch;
    const Mapper mapper = run_mapper(options, log, scans);
    const std::string name = text("outliers only, from %.2f m", distance);
    maps.push_back({name, to_cloud<2>(mapper.map()->points()), mapper.trajectory(), watch.seconds()});
    if (distance == usual)
      maps.push_back(
          {name + ", refined", to_cloud<2>(mapper.refined_map()->points()), mapper.trajectory(), watch.seconds()});
  }
  MapperOptions options;
  options.update = MapUpdate::all_points;
  const Stopwatch watch;
  const Mapper mapper = run_mapper(options, log, scans);
  maps.push_back({"all points", to_cloud<2>(mapper.map()->points()), mapper.trajectory(), watch.seconds()});
  return maps;
}

void walls(const Words& words) {
  const ScanLog log = open_scan_log(data("slam_benchmark/fr079.clf"));
  const auto relations = load_relations(data("slam_benchmark/fr079.relations"));
  const auto wanted = static_cast<std::size_t>(words.number("--scans"));
  const std::size_t scans = wanted > 0 ? std::min(wanted, log.size()) : log.size();
  const std::vector<Mapped> maps = build_maps(log, scans);
  const Bounds<2> detail = busiest_place(maps.front());
  const std::vector<Place> places = wall_places(maps.back().map);
  draw("outliers_only", maps.front(), detail);
  draw("outliers_only_refined", maps[1], detail);
  draw("all_points", maps.back(), detail);

  Table table({"map", "map points", "points per metre of wall", "thickness mm, median / p95", "extent mm, median / p95",
               "relation error m", "s"});
  Json results = Json::array();
  for (const Mapped& mapped : maps) {
    const Walls found = walls_of(mapped.map, places);
    const double error = relation_error(mapped.trajectory, relations).all.translation.mean;
    const auto millimetres = [](const std::vector<double>& lengths) {
      return text("%.0f / %.0f", 1e3 * quantile(lengths, 0.5), 1e3 * quantile(lengths, 0.95));
    };
    table.add({mapped.name, text("%zu", mapped.map.size()), text("%.0f", quantile(found.points_per_metre, 0.5)),
               millimetres(found.thickness), millimetres(found.extent), text("%.3f", error),
               text("%.0f", mapped.seconds)});
    results.push_back(
        {{"map", mapped.name},
         {"map_points", mapped.map.size()},
         {"points_per_metre_median", quantile(found.points_per_metre, 0.5)},
         {"thickness_m", {{"median", quantile(found.thickness, 0.5)}, {"p95", quantile(found.thickness, 0.95)}}},
         {"extent_m", {{"median", quantile(found.extent, 0.5)}, {"p95", quantile(found.extent, 0.95)}}},
         {"places", places.size()},
         {"places_with_three_points", found.thickness.size()},
         {"relation_error_m", error},
         {"seconds", mapped.seconds}});
  }
  std::printf(
      "FR079, %zu scans, each map by a run of its own; *outliers only, from d* adds points at least d from the map,\n"
      "*refined* is what `slamicp map` writes of it.\n"
      "Places: %zu, one for each %.1f m x %.1f m of the all-points map where its points within %.2f m lie along a "
      "line\n"
      "(spread across below %.1f of that along). At these places, of each map's points within %.2f m: points per metre "
      "is\n"
      "their number / %.1f m (median); thickness twice their standard deviation across the wall, extent from the "
      "first\n"
      "to the last across.\n\n",
      scans, places.size(), place_size, place_size, reach, elongation, reach, 2.0 * reach);
  table.print();
  save_results("walls", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { walls(Words(argc, argv, {{"--scans", "0"}})); });
}
