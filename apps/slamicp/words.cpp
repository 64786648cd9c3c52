// SPDX-License-Identifier: Apache-2.0
#include "words.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <vector>
#ifdef SLAMICP_WITH_YAML
#include <yaml-cpp/yaml.h>
#endif

#include <slamicp/error.hpp>

#include "output.hpp"

namespace slamicp::command {
namespace {

std::optional<Pose2> parse_pose(const std::string& text) {
  double value[3];
  const char* next = text.data();
  const char* const end = text.data() + text.size();
  for (int k = 0; k < 3; ++k) {
    const auto [stop, problem] = std::from_chars(next, end, value[k]);
    if (problem != std::errc() || !std::isfinite(value[k])) return std::nullopt;
    next = stop;
    if (k < 2 && (next == end || *next++ != ',')) return std::nullopt;
  }
  if (next != end) return std::nullopt;
  return Pose2{value[0], value[1], wrap_angle(value[2])};
}

}  // namespace

void add_example(CLI::App& verb, const std::string& example) { verb.footer("Example: " + example); }

bool is_map_server(const std::string& file) {
  const std::string name = CLI::detail::to_lower(file);
  return name.ends_with(".yaml") || name.ends_with(".yml");
}

void add_resolution(CLI::App& verb, double& resolution) {
  verb.add_option("--resolution", resolution, "the cells of a map_server map (.yaml) [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

CLI::Option* add_pose(CLI::App& verb, const std::string& name, std::optional<Pose2>& pose, const std::string& meaning) {
  const auto take = [&pose](const CLI::results_t& words) {
    pose = parse_pose(words.front());
    return pose.has_value();
  };
  CLI::Option* option = verb.add_option(name, take, meaning)->type_name("X,Y,THETA")->type_size(1)->expected(1);
  return option->check([name](const std::string& text) {
    return parse_pose(text) ? std::string()
                            : "'" + text + "' is no pose; give metres, metres, radians without blanks: 1.2,0.4,-1.57";
  });
}

void add_log_options(CLI::App& verb, ScanLogOptions& log) {
  add_pose(verb, "--laser-offset", log.laser_offset,
           "where the laser sits on the robot [m, m, rad]; default: as the log says");
  verb.add_option("--scan-topic", log.scan_topics,
                  "which topic of a ROS log holds scans; once more for each further laser; default: the only one, or "
                  "the one named scan")
      ->type_name("TOPIC")
      ->allow_extra_args(false);
  verb.add_option("--odometry-topic", log.odometry_topic,
                  "which topic of a ROS log holds odometry; default: the only one, or the one named odom, else tf")
      ->type_name("TOPIC");
  verb.add_option(
          "--base-frame", log.base_frame,
          "the frame of a ROS log that is the robot; default: the odometry's, else base_footprint, base_link or "
          "base")
      ->type_name("FRAME");
  verb.add_option("--fov-deg", log.fov_deg, "field of view of a ranges CSV, first beam to last [deg]")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 360.0));
  verb.add_option("--scan-rate-hz", log.scan_rate_hz, "scans a second of a ranges CSV, which has no stamps [Hz]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

void add_motion_options(CLI::App& verb, MotionOptions& options) {
  verb.add_flag_callback(
      "--no-odometry", [&] { options.use_odometry = false; }, "predict by the last fixes, not by the log's odometry");
  verb.add_flag_callback(
      "--no-deskew", [&] { options.deskew = false; },
      "take each scan as if measured all at once, though the log says it was not");
}

void add_method(CLI::App& verb, Method& method) {
  static const std::map<std::string, Method> names{{"point-to-point", Method::point_to_point},
                                                   {"point-to-line", Method::point_to_line},
                                                   {"point-to-plane", Method::point_to_plane}};
  const auto take = [&method](const CLI::results_t& words) {
    method = names.at(words.front());
    return true;
  };
  verb.add_option("--method", take,
                  "what the match makes small: point-to-line (point-to-plane in 3D) or point-to-point")
      ->type_name("NAME")
      ->default_str("point-to-line")
      ->check([](const std::string& word) {
        return names.contains(word)
                   ? std::string()
                   : "there is no method '" + word + "'; give point-to-line, point-to-plane or point-to-point";
      });
}

void add_match_options(CLI::App& verb, MatchOptions& options, double distance) {
  options.max_correspondence_distance = distance;
  add_method(verb, options.method);
  verb.add_option("--max-correspondence-distance", options.max_correspondence_distance,
                  "pairs farther apart take no part; closer ones are inliers: the paper's indist [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb.add_option("--max-iterations", options.max_iterations, "steps of a match at most")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb.add_option("--min-range", options.ranges.min_range, "leave out shorter readings [m]")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--max-range", options.ranges.max_range,
                  "leave out readings at or beyond [m]; default: the log's limit")
      ->check(CLI::PositiveNumber);
  verb.add_option("--threads", options.threads, "threads for preparing the map; the result is the same for any number")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
}

void add_config(CLI::App& verb) {
  verb.add_option("--config", "options from a file of 'name: value' lines; the command line goes before")
      ->type_name("FILE.yaml")
      ->check([](const std::string& file) {
        return std::filesystem::is_regular_file(file_named(file)) ? std::string() : "there is no file " + file;
      });
}

#ifdef SLAMICP_WITH_YAML

void read_config(CLI::App& verb) {
  const CLI::Option* config = verb.get_option("--config");
  if (config->count() == 0) return;
  const std::string path = config->as<std::string>();
  YAML::Node root;
  try {
    std::ifstream file(file_named(path));
    if (!file) throw Error("cannot be read", path, "check the file's name and who may read it");
    root = YAML::Load(file);
  } catch (const YAML::Exception& problem) {
    throw Error(problem.msg, path + ":" + std::to_string(problem.mark.line + 1), "write 'name: value' lines");
  }
  if (!root.IsMap()) throw Error("no 'name: value' pairs", path, "write lines such as 'max-range: 20'");
  for (const auto& entry : root) {
    const std::string name = entry.first.as<std::string>();
    const std::string where = path + ":" + std::to_string(entry.first.Mark().line + 1);
    CLI::Option* option = verb.get_option_no_throw("--" + name);
    if (option == nullptr || name == "config" || name == "help")
      throw Error("there is no option '" + name + "'", where, "slamicp help " + verb.get_name() + " lists them");
    const bool is_list = entry.second.IsSequence() && option->get_items_expected_max() > 1;
    if (!entry.second.IsScalar() && !is_list)
      throw Error("'" + name + "' has no single value", where, "write 'name: value'");
    if (option->count() > 0) continue;
    try {
      if (!is_list) option->add_result(entry.second.as<std::string>());
      for (std::size_t item = 0; is_list && item < entry.second.size(); ++item)
        option->add_result(entry.second[item].as<std::string>());
      option->run_callback();
    } catch (const CLI::Error& problem) {
      throw Error(problem.what(), where, "slamicp help " + verb.get_name() + " says what it takes");
    }
  }
}

#else

void read_config(CLI::App& verb) {
  const CLI::Option* config = verb.get_option("--config");
  if (config->count() > 0)
    throw Error("this build reads no YAML", config->as<std::string>(),
                "give the options on the command line, or build with yaml-cpp (Debian: libyaml-cpp-dev)");
}

#endif

}  // namespace slamicp::command
