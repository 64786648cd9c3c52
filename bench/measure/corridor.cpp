// SPDX-License-Identifier: Apache-2.0
// how exactly, how surely and how fast 1,081 beams are localized in a corridor map of 10,402 points (single matches)
//
// scripts/measure corridor [--guess-scale 2] [--repeats 4] [--seed 1] [--brute-force no]
//                          [--map M.csv --ranges R.csv --poses P.csv [--fov-deg 270]]   another world of the same kind
//
// Without --repeats and --guess-scale the guesses are those of the poses file; else they are drawn anew: truth plus
// Gaussian 5 cm, 5 cm, 2 deg times the scale, cut at 2.5 sigma.
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/random.hpp>

#include "scene.hpp"

namespace slamicp::measure {
namespace {

double cut_normal(Random& random) {
  while (true)
    if (const double value = random.normal(); std::abs(value) < 2.5) return value;
}

void draw_guesses(Scene& scene, int repeats, double scale, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Trial> once = std::move(scene.trials);
  scene.trials.clear();
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (Trial trial : once) {
      const double dx = 0.05 * scale * cut_normal(random);
      const double dy = 0.05 * scale * cut_normal(random);
      const double turn = 2.0 / deg_per_rad * scale * cut_normal(random);
      trial.guess = {trial.truth.x + dx, trial.truth.y + dy, wrap_angle(trial.truth.theta + turn)};
      scene.trials.push_back(trial);
    }
}

struct Variant {
  std::string name;
  IcpOptions icp;
  SurfaceOptions surfaces;
};

std::vector<Variant> variants() {
  std::vector<Variant> all;
  all.push_back({"default: point-to-line, shrinking gate", {}, {}});
  all.push_back({"gate kept at 0.3 m", {.final_gate = 0.3}, {}});
  all.push_back({"lines through 20 neighbours", {}, {.neighbours = 20}});
  all.push_back({"point-to-point, shrinking gate", {.method = Method::point_to_point}, {.neighbours = 0}});
  all.push_back(
      {"point-to-point, gate kept at 0.3 m", {.method = Method::point_to_point, .final_gate = 0.3}, {.neighbours = 0}});
  return all;
}

/// Which scan points are at least `limit` from every map point, all pairs looked at in double: the oracle.
std::vector<int> outliers_by_brute_force(const PointCloud2& map, const PointCloud2& scan, const Pose2& pose,
                                         double limit) {
  const Matrix<2, 2> rotation = pose.rotation();
  std::vector<int> outliers;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Point2 point = rotation * scan[i] + pose.translation();
    const auto near = [&](const Point2& other) { return (other - point).squaredNorm() < limit * limit; };
    if (std::none_of(map.begin(), map.end(), near)) outliers.push_back(static_cast<int>(i));
  }
  return outliers;
}

struct Score {
  std::vector<double> error_mm, rotation_deg, iterations, searches, outliers, times;
  std::size_t failures = 0;
  std::size_t agreeing = 0;  // outlier lists equal to brute force
};

constexpr int rounds = 3;  // of timing

Score measure(const Scene& scene, const Variant& variant, bool check_outliers) {
  const IndexedPoints<2> map(scene.map, variant.surfaces);
  Icp<2> icp(variant.icp);
  const Outputs wanted{.outlier_indices = true, .outliers_in_map = true};
  Score score;
  for (const Trial& trial : scene.trials) {
    const PointCloud2& scan = scene.scans[trial.scan];
    const IcpResult2& result = icp.align(map, scan, trial.guess, wanted);
    const PoseDistance error = distance(result.pose, trial.truth);
    score.error_mm.push_back(1e3 * error.translation);
    score.rotation_deg.push_back(deg_per_rad * error.rotation);
    score.failures += error.translation > 0.1 || deg_per_rad * error.rotation > 1.0 ? 1U : 0U;
    score.iterations.push_back(result.iterations);
    score.searches.push_back(static_cast<double>(result.searches + result.searches_for_outputs));
    score.outliers.push_back(static_cast<double>(result.outlier_indices.size()));
    if (check_outliers && result.outlier_indices ==
                              outliers_by_brute_force(scene.map, scan, result.pose, variant.icp.outlier_threshold()))
      ++score.agreeing;
  }
  for (int round = 0; round < rounds; ++round)
    for (const Trial& trial : scene.trials) {
      const Stopwatch watch;
      icp.align(map, scene.scans[trial.scan], trial.guess, wanted);
      score.times.push_back(watch.microseconds());
    }
  return score;
}

Json tell(const Scene& scene, const Variant& variant, const Score& score, bool checked, Table& table) {
  const auto trials = static_cast<double>(scene.trials.size());
  const double agreement = 100.0 * static_cast<double>(score.agreeing) / trials;
  table.add(
      {scene.name, variant.name,
       text("%.2f / %.2f / %.2f", mean(score.error_mm), quantile(score.error_mm, 0.95), quantile(score.error_mm, 1.0)),
       text("%.3f", quantile(score.rotation_deg, 0.95)), text("%zu of %zu", score.failures, scene.trials.size()),
       text("%.1f", mean(score.iterations)), text("%.0f", mean(score.searches)), text("%.1f", mean(score.outliers)),
       checked ? text("%.4g %%", agreement) : "not checked", text("%.0f", quantile(score.times, 0.5))});
  return {{"world", scene.name},
          {"variant", variant.name},
          {"trials", scene.trials.size()},
          {"error_mm",
           {{"mean", mean(score.error_mm)},
            {"p95", quantile(score.error_mm, 0.95)},
            {"max", quantile(score.error_mm, 1.0)}}},
          {"rotation_p95_deg", quantile(score.rotation_deg, 0.95)},
          {"failures", score.failures},
          {"iterations_mean", mean(score.iterations)},
          {"searches_mean", mean(score.searches)},
          {"outliers_mean", mean(score.outliers)},
          {"outliers_equal_brute_force", checked ? Json(score.agreeing) : Json(nullptr)},
          {"time_us", {{"median", quantile(score.times, 0.5)}, {"p95", quantile(score.times, 0.95)}}}};
}

std::vector<Scene> scenes(const Words& words) {
  const double fov_deg = words.number("--fov-deg");
  if (!words["--map"].empty())
    return {load_scene("given", words["--map"], words["--ranges"], words["--poses"], fov_deg)};
  std::vector<Scene> all;
  for (const std::string name : {"none", "box"}) all.push_back(load_corridor(name));
  return all;
}

void corridor(const Words& words) {
  const double scale = words.number("--guess-scale");
  const int repeats = static_cast<int>(words.number("--repeats"));
  const bool drawn = repeats > 0 || scale != 1.0;
  const bool check = words["--brute-force"] == "yes";
  std::vector<Scene> all = scenes(words);
  Table table({"world", "method", "error mm mean / p95 / max", "rotation p95 deg", "failures", "iterations",
               "searches a scan", "outliers", "equal to brute force", "us a scan"});
  Json results = Json::array();
  for (Scene& scene : all) {
    if (drawn) draw_guesses(scene, std::max(1, repeats), scale, static_cast<std::uint64_t>(words.number("--seed")));
    for (const Variant& variant : variants())
      results.push_back(tell(scene, variant, measure(scene, variant, check), check, table));
  }
  std::printf(
      "Guess: %s, Gaussian %.0f cm, %.0f cm, %.0f deg (1 sigma), cut at 2.5. Gate and outlier distance 0.3 m.\n"
      "Failure: off by more than 0.1 m or 1 deg. Time: median, one thread, outliers included, map ready.\n\n",
      drawn ? "seeded" : "as the data have it", 5.0 * scale, 5.0 * scale, 2.0 * scale);
  table.print();
  save_results("corridor", {{"guess_scale", scale}, {"results", results}});
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] {
    corridor(Words(argc, argv,
                   {{"--map", ""},
                    {"--ranges", ""},
                    {"--poses", ""},
                    {"--fov-deg", "270"},
                    {"--guess-scale", "1"},
                    {"--repeats", "0"},
                    {"--seed", "1"},
                    {"--brute-force", "yes"}}));
  });
}
