// SPDX-License-Identifier: Apache-2.0
// slamicp align: register two clouds.
#include <charconv>
#include <memory>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/geometry/voxel_grid.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/registration/icp.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct AlignWords {
  std::string source, target, transform, outliers, merged, json;
  std::vector<double> initial_pose;
  double voxel = 0.0;
  IcpOptions icp;
};

Pose2 initial_pose_2d(const std::vector<double>& values) {
  if (values.empty()) return {};
  if (values.size() != 3) throw Error("2D clouds need X,Y,THETA", "--initial-pose", "give three numbers [m, m, rad]");
  return {values[0], values[1], wrap_angle(values[2])};
}

Pose3 initial_pose_3d(const std::vector<double>& values) {
  if (values.empty()) return {};
  if (values.size() != 6)
    throw Error("3D clouds need X,Y,Z,ROLL,PITCH,YAW", "--initial-pose", "give six numbers [m, rad]");
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(values[5], Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(values[4], Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(values[3], Eigen::Vector3d::UnitX());
  return {{values[0], values[1], values[2]}, Pose3::Quaternion(turn)};
}

/// T_target_source as (D+1) x (D+1) numbers, row by row.
template <int D>
std::vector<std::vector<double>> matrix_rows(const Pose<D>& pose) {
  const Matrix<D, D> rotation = pose.rotation();
  const Point<D> translation = pose.translation();
  std::vector<std::vector<double>> rows(D + 1, std::vector<double>(D + 1, 0.0));
  for (int r = 0; r < D; ++r) {
    for (int c = 0; c < D; ++c) rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = rotation(r, c);
    rows[static_cast<std::size_t>(r)][D] = translation[r];
  }
  rows[D][D] = 1.0;
  return rows;
}

std::string to_text(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const auto& row : rows) {
    for (const double value : row) text += format(&value == row.data() ? "%.12g" : " %.12g", value);
    text += "\n";
  }
  return text;
}

template <int D>
std::string outliers_csv(const IcpResult<D>& result) {
  std::string text = D == 2 ? "index,x,y,distance\n" : "index,x,y,z,distance\n";
  for (std::size_t k = 0; k < result.outlier_indices.size(); ++k) {
    const int i = result.outlier_indices[k];
    text += std::to_string(i);
    for (int axis = 0; axis < D; ++axis) text += format(",%.6f", result.outliers_in_map[k][axis]);
    text += format(",%.6f\n", result.matches[static_cast<std::size_t>(i)].distance);
  }
  return text;
}

template <int D>
void align_clouds(const AlignWords& words, PointCloud<D> source, PointCloud<D> target, const Pose<D>& guess) {
  if (words.voxel > 0.0) {
    source = voxel_downsampled<D>(source, words.voxel);
    target = voxel_downsampled<D>(target, words.voxel);
  }
  const Stopwatch watch;
  const IcpResult<D> result = align<D>(source, target, guess, words.icp);
  const double milliseconds = watch.microseconds() * 1e-3;
  const auto rows = matrix_rows<D>(result.pose);
  if (!words.transform.empty()) write_file(file_named(words.transform), to_text(rows));
  if (!words.outliers.empty()) write_file(file_named(words.outliers), outliers_csv<D>(result));
  if (!words.merged.empty()) save_cloud(file_named(words.merged), result.updated_map);
  write_json(words.json, {{"verb", "align"},
                          {"source", words.source},
                          {"target", words.target},
                          {"dimension", D},
                          {"source_points", source.size()},
                          {"target_points", target.size()},
                          {"stop", to_string(result.stop)},
                          {"iterations", result.iterations},
                          {"inliers", result.inliers},
                          {"outliers", result.outlier_indices.size()},
                          {"mean_inlier_distance", result.mean_inlier_distance},
                          {"T_target_source", rows},
                          {"milliseconds", milliseconds}});
  Talk{words.json}(format("%zu points onto %zu in %.1f ms: ", source.size(), target.size(), milliseconds) +
                   result.brief());
  if (!result.usable())
    warn("the match ended with " + std::string(to_string(result.stop)) +
         ": give a better --initial-pose, or a larger --max-correspondence-distance");
}

void run(const AlignWords& words) {
  const Cloud source = load_cloud(file_named(words.source));
  const Cloud target = load_cloud(file_named(words.target));
  warn(source.warnings);
  warn(target.warnings);
  if (source.dimension() != target.dimension())
    throw Error(format("the clouds have %d and %d dimensions", source.dimension(), target.dimension()),
                words.source + ", " + words.target, "register 2D to 2D, or 3D to 3D");
  if (source.dimension() == 2)
    align_clouds<2>(words, std::get<PointCloud2>(source.points), std::get<PointCloud2>(target.points),
                    initial_pose_2d(words.initial_pose));
  else
    align_clouds<3>(words, std::get<PointCloud3>(source.points), std::get<PointCloud3>(target.points),
                    initial_pose_3d(words.initial_pose));
}

}  // namespace

void add_align(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("align", "register two clouds, 2D or 3D");
  const auto words = std::make_shared<AlignWords>();
  words->icp.max_iterations = 100;
  verb->add_option("SOURCE", words->source, "the cloud that moves: .csv .xyz .pcd .ply")->required();
  verb->add_option("TARGET", words->target, "the cloud that stays")->required();
  add_method(*verb, words->icp.method);
  verb->add_option("--initial-pose", words->initial_pose,
                   "where the source should be: X,Y,THETA or X,Y,Z,ROLL,PITCH,YAW [m, rad]; default: the identity")
      ->delimiter(',')
      ->expected(3, 6);
  verb->add_option("--voxel", words->voxel, "thin both clouds to a point a cube of this size [m]; 0: as they are")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--max-correspondence-distance", words->icp.max_correspondence_distance,
                   "pairs farther apart take no part; closer ones are inliers [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--outlier-distance", words->icp.outlier_distance,
                   "points at least this far from every target point are outliers [m]; default: the distance above")
      ->check(CLI::PositiveNumber);
  verb->add_option("--max-iterations", words->icp.max_iterations, "steps at most")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--transform", words->transform, "T_target_source: 4x4 numbers, 3x3 in 2D, row by row")
      ->type_name("TXT");
  verb->add_option("--outliers", words->outliers, "source points that fit nothing")->type_name("CSV");
  verb->add_option("--merged", words->merged, "the target and the source's outliers")->type_name("CLOUD");
  add_config(*verb);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp align scan.ply map.ply --voxel 0.25 --max-correspondence-distance 1 --transform T.txt");
  verb->callback([verb, words] {
    read_config(*verb);
    run(*words);
  });
}

}  // namespace slamicp::command
