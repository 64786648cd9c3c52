// SPDX-License-Identifier: Apache-2.0

#include <slamicp/evaluation/scan_pair.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/simulation/corridor_world.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

constexpr Colour start_colour{122, 40, 160};
constexpr Colour end_colour{34, 160, 84};

/// The pictures of an experiment, each to the folder and to the page.
class Figures {
 public:
  Figures(const Folder& folder, Page& page) : folder_(folder), page_(page) {}

  void add(const std::string& name, const Picture& picture, const std::string& caption) {
    folder_.save("figure_" + name, picture);
    page_.figure(picture.svg(), "Figure " + name + ": " + caption);
  }

 private:
  const Folder& folder_;
  Page& page_;
};

// ---- Figures 2, 3 and 6 to 8: two scans -----------------------------------------------------------------------------

Bounds<2> around(const ScanPair& scans) {
  PointCloud2 all = scans.M;
  for (const Point2& point : scans.T) {
    all.push_back(point);
    all.push_back(scans.truth * point);
  }
  Bounds<2> bounds = bounds_of<2>(all);
  bounds.lower.array() -= 0.5;
  bounds.upper.array() += 0.5;
  return bounds;
}

Picture picture_of(const std::string& title, const Bounds<2>& bounds) {
  PictureOptions options;
  options.title = title;
  options.bounds = bounds;
  options.width_px = 700.0;
  return Picture(options);
}

std::string legend(const char* what, const PointCloud2& points) {
  return format("%s, %zu points", what, points.size());
}

void draw_scans(const std::string& figure, const MatchedPair& pair, Figures& figures) {
  const Bounds<2> bounds = around(pair.scans);
  Picture a = picture_of("Figure " + figure + "a: M, where the robot starts", bounds);
  a.points(pair.scans.M, colours::map, 1.3, legend("M", pair.scans.M)).robot({}, 0.15);
  figures.add(figure + "a", a, legend("the scan M", pair.scans.M));
  Picture b = picture_of("Figure " + figure + "b: T, after it has moved, as the robot sees it", bounds);
  b.points(pair.scans.T, colours::obstacle, 1.3, legend("T", pair.scans.T)).robot({}, 0.15);
  figures.add(figure + "b", b, legend("the scan T", pair.scans.T));
}

void draw_match(const std::string& figure, const MatchedPair& pair, Figures& figures) {
  Picture a = picture_of("Figure " + figure + "a: tT in M, and the robot's pose", around(pair.scans));
  a.points(pair.scans.M, colours::map, 1.3, legend("M", pair.scans.M));
  a.points(pair.result.transformed_scan, colours::obstacle, 1.1, legend("tT", pair.result.transformed_scan));
  a.robot({}, 0.15, colours::truth, "where M was taken").robot(pair.result.pose, 0.15, colours::robot, "matched pose");
  figures.add(figure + "a", a, "T moved by the match onto M");
}

void draw_classes(const std::string& figure, const MatchedPair& pair, Figures& figures) {
  Picture a = picture_of("Figure " + figure + "a: inliers and outliers of tT in M", around(pair.scans));
  a.points(pair.scans.M, colours::map, 1.3, legend("M", pair.scans.M));
  a.points(pair.inliers, colours::inlier, 1.1, legend("inliers", pair.inliers));
  a.points(pair.result.outliers_in_map, colours::outlier, 1.3, legend("outliers", pair.result.outliers_in_map));
  a.robot({}, 0.15, colours::truth, "where M was taken").robot(pair.result.pose, 0.15, colours::robot, "matched pose");
  figures.add(figure + "a", a, "what M knows and what it does not");
}

void draw_updated(const std::string& figure, const std::string& title, const PointCloud2& map, const MatchedPair& pair,
                  const std::string& caption, Figures& figures) {
  Picture b = picture_of("Figure " + figure + "b: " + title, around(pair.scans));
  b.points(map, colours::map, 1.1, legend("uM", map));
  figures.add(figure + "b", b, caption);
}

void draw_ideal(const MatchedPair& pair, Figures& figures) {
  draw_scans("2", pair, figures);
  draw_match("3", pair, figures);
  draw_updated("3", "the updated map", pair.result.updated_map, pair, legend("the map", pair.result.updated_map),
               figures);
}

void draw_real(const MatchedPair& pair, Figures& figures) {
  draw_scans("6", pair, figures);
  draw_match("7", pair, figures);
  draw_updated("7", "uM from all points: thick walls", pair.all_points_map, pair,
               format("the map of all points, %zu (the paper: 2162)", pair.all_points_map.size()), figures);
  draw_classes("8", pair, figures);
  draw_updated("8", "uM from the outliers only", pair.result.updated_map, pair,
               format("the map with the outliers only, %zu points (the paper: 1617; its scans are of another place)",
                      pair.result.updated_map.size()),
               figures);
}

// ---- Figures 4 and 5: the site --------------------------------------------------------------------------------------

void draw_site(const ExperimentSite& site, Figures& figures) {
  Picture picture = draw_map(site, "Figure 4: the map and the reference path");
  const PointCloud2 path = path_of(site);
  picture.polyline(path, colours::path, 1.6, format("reference path, %.1f m", site.path->length()));
  picture.points(std::vector<Point2>{path.front()}, start_colour, 5.0, "start");
  picture.points(std::vector<Point2>{path.back()}, end_colour, 5.0, "end");
  figures.add(
      "4", picture,
      format("the map of the exploration, %zu points (the paper: 10402), and the s-shaped path", site.map->size()));
}

void draw_placements(const ExperimentSite& site, char kind, const std::string& what, Figures& figures) {
  Picture picture = draw_map(site, format("Figure 5, obstacles %c: %s", kind, what.c_str()));
  picture.polyline(path_of(site), colours::path, 1.2, "reference path");
  bool first = true;
  for (const PlacedObstacle& obstacle : corridor_obstacles()) {
    if (obstacle.name.front() != kind) continue;
    Point2 at = Point2::Zero();
    for (const Box& box : obstacle.boxes) {
      PointCloud2 outline;
      for (const Segment& side : sides(box)) outline.push_back(side.a);
      outline.push_back(outline.front());
      picture.polyline(outline, colours::outlier, 2.5, first ? "obstacle" : "");
      at = box.centre;
      first = false;
    }
    for (const Cylinder& cylinder : obstacle.cylinders) {
      picture.circle(cylinder.centre, cylinder.radius, colours::outlier, 2.5, first ? "obstacle" : "");
      at = cylinder.centre;
      first = false;
    }
    picture.label(at + Point2(0.3, at.y() > 1.25 ? -0.35 : 0.15), obstacle.name);  // off the walls
  }
  figures.add(std::string("5") + kind, picture, what + ", at three places");
}

void draw_all_placements(const ExperimentSite& site, Figures& figures) {
  draw_placements(site, 'A', "box of 480 x 215 mm", figures);
  draw_placements(site, 'B', "cylinder of 42 mm radius", figures);
  draw_placements(site, 'C', "two cylinders of 50 mm radius", figures);
  draw_placements(site, 'D', "cylinder of 135 mm radius", figures);
}

// ---- numbers --------------------------------------------------------------------------------------------------------

struct Row {
  const char* figures;
  const char* paper;
  const MatchedPair& pair;
};

std::vector<std::string> cells(const Row& row) {
  const MatchedPair& pair = row.pair;
  const PoseDistance error = distance(pair.result.pose, pair.scans.truth);
  return {row.figures,
          format("%zu", pair.scans.M.size()),
          format("%zu", pair.scans.T.size()),
          format("%zu", pair.result.inliers),
          format("%zu", pair.result.outlier_indices.size()),
          format("%zu", pair.all_points_map.size()),
          format("%zu", pair.result.updated_map.size()),
          row.paper,
          format("%.2f", 1e3 * error.translation),
          format("%.3f", deg_per_rad * error.rotation)};
}

Json match_json(const Row& row) {
  const PoseDistance error = distance(row.pair.result.pose, row.pair.scans.truth);
  return {{"figures", row.figures},
          {"M", row.pair.scans.M.size()},
          {"T", row.pair.scans.T.size()},
          {"inliers", row.pair.result.inliers},
          {"outliers", row.pair.result.outlier_indices.size()},
          {"updated_all_points", row.pair.all_points_map.size()},
          {"updated_outliers_only", row.pair.result.updated_map.size()},
          {"error_mm", 1e3 * error.translation},
          {"error_deg", deg_per_rad * error.rotation}};
}

std::string csv_of(const std::vector<std::vector<std::string>>& rows) {
  std::string csv = "figures,M,T,inliers,outliers,map_all_points,map_outliers_only,paper,error_mm,error_deg\n";
  for (std::size_t k = 1; k < rows.size(); ++k)
    for (std::size_t c = 0; c < rows[k].size(); ++c) csv += rows[k][c] + (c + 1 < rows[k].size() ? "," : "\n");
  return csv;
}

}  // namespace

Json run_maps(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk) {
  const MatchedPair ideal = match(ideal_scan_pair());
  const MatchedPair real = match(corridor_scan_pair(words.seed));
  Page page("Figures 2 to 8: scans, the site, and what becomes a map");
  tell_what_is_simulated(page, site);
  page.paragraph(
      "Figures 2 and 3 stand in a room of our own, like the paper's sketch, without noise; 6 to 8 in the simulated "
      "corridor with 1 cm of noise. Scan T onto scan M: the guess is off by 5 cm, 5 cm, 2 deg; correspondences and "
      "outliers at 0.3 m.");
  const Row pairs[] = {{"2 and 3", "", ideal}, {"6 to 8", "2162 and 1617", real}};
  std::vector<std::vector<std::string>> rows{{"figures", "M", "T", "inliers", "outliers", "map, all points",
                                              "map, outliers only", "the paper's", "error mm", "error deg"}};
  Json results = Json::array();
  for (const Row& row : pairs) {
    rows.push_back(cells(row));
    results.push_back(match_json(row));
    talk(format("%-9s M %zu, T %zu: %zu inliers, %zu outliers; map of all points %zu, of outliers only %zu",
                row.figures, row.pair.scans.M.size(), row.pair.scans.T.size(), row.pair.result.inliers,
                row.pair.result.outlier_indices.size(), row.pair.all_points_map.size(),
                row.pair.result.updated_map.size()));
  }
  page.table(rows);
  Figures figures(folder, page);
  page.heading("Figures 2 and 3: ideal scans");
  draw_ideal(ideal, figures);
  page.heading("Figures 4 and 5: the site");
  draw_site(site, figures);
  draw_all_placements(site, figures);
  page.heading("Figures 6 to 8: two scans and the two maps");
  draw_real(real, figures);
  folder.save_text("maps.csv", csv_of(rows));
  folder.save_text("maps.html", page.html());
  return {{"pairs", results}};
}

}  // namespace slamicp::command
