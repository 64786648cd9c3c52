// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <slamicp_node/parameters.hpp>
#include <string_view>

#include <slamicp/error.hpp>
#include <slamicp/io/spelling.hpp>

namespace slamicp::node {
namespace {

constexpr double any = std::numeric_limits<double>::infinity();

using Place = std::variant<bool NodeOptions::*, int NodeOptions::*, double NodeOptions::*, std::string NodeOptions::*,
                           std::vector<std::string> NodeOptions::*>;

struct Entry {
  const char* name;
  Place place;
  const char* unit;
  double least, most;  // of numbers
  const char* meaning;
};

const std::vector<Entry>& entries() {
  using O = NodeOptions;
  static const std::vector<Entry> all{
      {"mode", &O::mode, "", 0, 0, "localization, in a map; or mapping: make one"},
      {"map_file", &O::map_file, "", 0, 0, "the map: .yaml of map_server, .pcd, .ply, .csv; published too"},
      {"use_map_topic", &O::use_map_topic, "", 0, 0,
       "without a map_file: the map is that of map_topic; else of service static_map"},
      {"map_topic", &O::map_topic, "", 0, 0, "where the map comes from, or is published"},
      {"first_map_only", &O::first_map_only, "", 0, 0, "later maps on the topic are left alone"},
      {"scan_topics", &O::scan_topics, "", 0, 0, "a list; each laser sits where tf says"},
      {"odom_topic", &O::odom_topic, "", 0, 0, "odometry by nav_msgs/Odometry; empty: by tf"},
      {"global_frame_id", &O::global_frame_id, "", 0, 0, "the map's frame"},
      {"odom_frame_id", &O::odom_frame_id, "", 0, 0, "the frame of odometry"},
      {"base_frame_id", &O::base_frame_id, "", 0, 0, "the frame that moves with the robot, whose pose is told"},
      {"use_odometry", &O::use_odometry, "", 0, 0,
       "false: constant velocity from scan to scan, and tf goes from map to base"},
      {"odometry_wait", &O::odometry_wait, "s", 0, 10, "a scan waits so long for odometry that reaches its last beam"},
      {"scan_timeout", &O::scan_timeout, "s", 0.01, 1e6, "without a scan for so long the state is waiting_for_scan"},
      {"initial_pose_x", &O::initial_pose_x, "m", -any, any, "where the robot starts in the map"},
      {"initial_pose_y", &O::initial_pose_y, "m", -any, any, "the same"},
      {"initial_pose_a", &O::initial_pose_a, "rad", -any, any, "the same: its heading"},
      {"wait_for_initial_pose", &O::wait_for_initial_pose, "", 0, 0, "start when initialpose has come, not before"},
      {"tf_broadcast", &O::tf_broadcast, "", 0, 0, "publish tf"},
      {"transform_tolerance", &O::transform_tolerance, "s", 0, 10, "tf is stamped so far in the future"},
      {"save_pose_rate", &O::save_pose_rate, "Hz", 0, 100, "the pose is written to initial_pose_* so often; 0: never"},
      {"min_range", &O::min_range, "m", 0, 1e9, "leave out shorter readings"},
      {"max_range", &O::max_range, "m", 0, 1e9, "leave out readings at or beyond"},
      {"max_correspondence_distance", &O::max_correspondence_distance, "m", 1e-3, 100,
       "pairs farther apart take no part"},
      {"outlier_distance", &O::outlier_distance, "m", 0, 100,
       "a point so far from the map is an outlier; 0: as the one above"},
      {"obstacle_distance", &O::obstacle_distance, "m", 0, 100, "an obstacle is so far from the map; 0: by the noise"},
      {"max_iterations", &O::max_iterations, "", 1, 1000, "steps of a match at most"},
      {"deskew", &O::deskew, "", 0, 0, "points are taken from where the robot was when their beam was measured"},
      {"recover", &O::recover, "", 0, 0, "where the pose is suspect or lost, look around: 3 m, all headings"},
      {"recover_places", &O::recover_places, "", 1, 1e6,
       "places it looks at a scan; 1000 take about half a millisecond"},
      {"map_update_interval", &O::map_update_interval, "s", 0.1, 1e6, "while mapping, map is published so often"},
      {"resolution", &O::resolution, "m", 0.005, 1, "the side of a cell of the map that is published"},
  };
  return all;
}

struct Unused {
  const char* name;
  const char* why;
};
constexpr const char* no_particles = "there are no particles";
constexpr const char* every_scan = "every scan is localized";
constexpr const char* by_match = "the match weighs ranges by their own noise";
constexpr const char* by_surface = "how sure odometry is has fixed values";
constexpr const char* no_lifecycle = "it is no lifecycle node";
constexpr const char* no_services = "it has no services of ROS 2";
constexpr const char* fixed_quality = "the qualities of its topics are fixed";
constexpr const char* start_is_searched = "the start may be off by a match distance, or by 3 m with recover";

constexpr Unused unused[] = {{"min_particles", no_particles},
                             {"max_particles", no_particles},
                             {"kld_err", no_particles},
                             {"kld_z", no_particles},
                             {"resample_interval", no_particles},
                             {"selective_resampling", no_particles},
                             {"recovery_alpha_slow", no_particles},
                             {"recovery_alpha_fast", no_particles},
                             {"do_beamskip", "what the map does not have is an outlier anyway"},
                             {"beam_skip_distance", "what the map does not have is an outlier anyway"},
                             {"beam_skip_threshold", "what the map does not have is an outlier anyway"},
                             {"beam_skip_error_threshold", "what the map does not have is an outlier anyway"},
                             {"update_min_d", every_scan},
                             {"update_min_a", every_scan},
                             {"gui_publish_rate", every_scan},
                             {"bag_scan_period", "bags are localized by slamicp localize"},
                             {"restore_defaults", "nothing is reconfigured while it runs"},
                             {"force_update_after_initialpose", every_scan},
                             {"force_update_after_set_map", every_scan},
                             {"std_warn_level_x", "diagnostics go by the state"},
                             {"std_warn_level_y", "diagnostics go by the state"},
                             {"std_warn_level_yaw", "diagnostics go by the state"},
                             {"laser_max_beams", "all beams are used"},
                             {"laser_z_hit", by_match},
                             {"laser_z_short", by_match},
                             {"laser_z_max", by_match},
                             {"laser_z_rand", by_match},
                             {"laser_sigma_hit", by_match},
                             {"laser_lambda_short", by_match},
                             {"laser_likelihood_max_dist", by_match},
                             {"laser_model_type", by_match},
                             {"odom_model_type", by_surface},
                             {"odom_alpha1", by_surface},
                             {"odom_alpha2", by_surface},
                             {"odom_alpha3", by_surface},
                             {"odom_alpha4", by_surface},
                             {"odom_alpha5", by_surface},
                             {"initial_cov_xx", start_is_searched},
                             {"initial_cov_yy", start_is_searched},
                             {"initial_cov_aa", start_is_searched},
                             {"pf_err", no_particles},
                             {"pf_z", no_particles},
                             {"random_seed", no_particles},
                             {"freespace_downsampling", no_particles},
                             {"max_beams", "all beams are used"},
                             {"z_hit", by_match},
                             {"z_short", by_match},
                             {"z_max", by_match},
                             {"z_rand", by_match},
                             {"sigma_hit", by_match},
                             {"lambda_short", by_match},
                             {"robot_model_type", by_surface},
                             {"alpha1", by_surface},
                             {"alpha2", by_surface},
                             {"alpha3", by_surface},
                             {"alpha4", by_surface},
                             {"alpha5", by_surface},
                             {"initial_pose.z", "the robot drives in a plane"},
                             {"always_reset_initial_pose", "no pose is kept from one run to the next"},
                             {"bond_heartbeat_period", no_lifecycle},
                             {"introspection_mode", no_services},
                             {"service_introspection_mode", no_services},
                             {"start_type_description_service", no_services},
                             {"allow_parameter_qos_overrides", fixed_quality},
                             {"qos_overrides.*", fixed_quality}};

const Unused* unused_of(std::string_view name) {
  for (const Unused& other : unused) {
    const std::string_view all = other.name;
    const bool stands_for_many = all.back() == '*';
    if (name == all || (stands_for_many && name.substr(0, all.size() - 1) == all.substr(0, all.size() - 1)))
      return &other;
  }
  return nullptr;
}

/// amcl's names for what has another one here, or other values.
struct Alias {
  const char* name;
  const char* ours;
  enum class Meaning {
    same,
    opposite,
    same_unless_negative,  ///< -1 stands for what the scan says itself
    never_if_negative,
  } meaning;
};
using Meaning = Alias::Meaning;
constexpr Alias aliases[] = {{"laser_min_range", "min_range", Meaning::same_unless_negative},
                             {"laser_max_range", "max_range", Meaning::same_unless_negative},
                             {"save_pose_rate", "save_pose_rate", Meaning::never_if_negative},
                             {"scan_topic", "scan_topics", Meaning::same},
                             {"set_initial_pose", "wait_for_initial_pose", Meaning::opposite},
                             {"initial_pose.x", "initial_pose_x", Meaning::same},
                             {"initial_pose.y", "initial_pose_y", Meaning::same},
                             {"initial_pose.yaw", "initial_pose_a", Meaning::same}};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string type_of(const Place& place) {
  constexpr const char* names[] = {"bool", "int", "double", "string", "list of strings"};
  return names[place.index()];
}

const Entry* entry_of(std::string_view name) {
  for (const Entry& entry : entries())
    if (name == entry.name) return &entry;
  return nullptr;
}

const Alias* alias_of(std::string_view name) {
  for (const Alias& alias : aliases)
    if (name == alias.name) return &alias;
  return nullptr;
}

[[noreturn]] void refuse_name(const std::string& name) {
  std::vector<std::string_view> known;
  for (const Entry& entry : entries()) known.emplace_back(entry.name);
  for (const Alias& alias : aliases) known.emplace_back(alias.name);
  for (const Unused& other : unused) known.emplace_back(other.name);
  const std::string_view nearest = text::nearest_name(name, known);
  throw Error(
      "there is no parameter '" + name + "'", "parameters",
      nearest.empty() ? "slamicp_node --parameters lists them" : "did you mean '" + std::string(nearest) + "'?");
}

[[noreturn]] void refuse_type(const Entry& entry) {
  throw Error(std::string("'") + entry.name + "' is a " + type_of(entry.place), "parameters",
              "give it as one, without quotes around numbers");
}

std::optional<double> as_number(const Value& value) {
  if (const int* whole = std::get_if<int>(&value)) return *whole;
  if (const double* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

void check_range(const Entry& entry, double value) {
  if (std::isfinite(value) && value >= entry.least && value <= entry.most) return;
  throw Error(std::string("'") + entry.name + "' is " + number(value), "parameters",
              "give a number from " + number(entry.least) + " to " + number(entry.most));
}

void choose(const Entry& entry, const Value& value, NodeOptions& options) {
  const std::optional<double> real = as_number(value);
  if (const auto* flag = std::get_if<bool NodeOptions::*>(&entry.place)) {
    if (!std::holds_alternative<bool>(value)) refuse_type(entry);
    options.*(*flag) = std::get<bool>(value);
  } else if (const auto* whole = std::get_if<int NodeOptions::*>(&entry.place)) {
    if (!real || *real != std::floor(*real)) refuse_type(entry);
    check_range(entry, *real);
    options.*(*whole) = static_cast<int>(*real);
  } else if (const auto* any_number = std::get_if<double NodeOptions::*>(&entry.place)) {
    if (!real) refuse_type(entry);
    check_range(entry, *real);
    options.*(*any_number) = *real;
  } else if (const auto* words = std::get_if<std::string NodeOptions::*>(&entry.place)) {
    if (!std::holds_alternative<std::string>(value)) refuse_type(entry);
    options.*(*words) = std::get<std::string>(value);
  } else {
    std::vector<std::string>& list = options.*std::get<std::vector<std::string> NodeOptions::*>(entry.place);
    if (const auto* one = std::get_if<std::string>(&value))
      list = {*one};
    else if (const auto* several = std::get_if<std::vector<std::string>>(&value))
      list = *several;
    else
      refuse_type(entry);
  }
}

void choose_by(const Alias& alias, const Value& value, NodeOptions& options) {
  const Entry& entry = *entry_of(alias.ours);
  const std::optional<double> given = as_number(value);
  const bool is_negative = given && *given < 0.0;
  if (alias.meaning == Meaning::same_unless_negative && is_negative) return;
  if (alias.meaning == Meaning::never_if_negative && is_negative) {
    choose(entry, 0.0, options);
  } else if (const bool* const flag = std::get_if<bool>(&value);
             alias.meaning == Meaning::opposite && flag != nullptr) {
    choose(entry, !*flag, options);
  } else {
    choose(entry, value, options);
  }
}

std::string told(const Place& place, const NodeOptions& options) {
  if (const auto* flag = std::get_if<bool NodeOptions::*>(&place)) return options.*(*flag) ? "true" : "false";
  if (const auto* whole = std::get_if<int NodeOptions::*>(&place)) return std::to_string(options.*(*whole));
  if (const auto* real = std::get_if<double NodeOptions::*>(&place)) return number(options.*(*real));
  if (const auto* words = std::get_if<std::string NodeOptions::*>(&place)) return options.*(*words);
  std::string list;
  for (const std::string& word : options.*std::get<std::vector<std::string> NodeOptions::*>(place))
    list += (list.empty() ? "[" : ", ") + word;
  return list + "]";
}

std::string range_of(const Entry& entry) {
  const bool is_number = entry.place.index() == 1 || entry.place.index() == 2;
  if (!is_number || (entry.least == -any && entry.most == any)) return {};
  return number(entry.least) + " .. " + number(entry.most);
}

}  // namespace

std::string NodeOptions::problem() const {
  if (mode != "localization" && mode != "mapping") return "mode must be localization or mapping, not '" + mode + "'";
  if (mode == "mapping" && !map_file.empty()) return "map_file must be empty while mapping: save_map writes one";
  if (scan_topics.empty()) return "scan_topics must name one topic at least";
  if (map_topic.empty()) return "map_topic must not be empty";
  if (global_frame_id.empty() || base_frame_id.empty()) return "global_frame_id and base_frame_id must not be empty";
  if (use_odometry && odom_frame_id.empty()) return "odom_frame_id must not be empty, unless use_odometry is false";
  if (global_frame_id == odom_frame_id || global_frame_id == base_frame_id || odom_frame_id == base_frame_id)
    return "global_frame_id, odom_frame_id and base_frame_id must differ";
  if (!(max_range > min_range)) return "max_range must be above min_range";
  return {};
}

std::vector<ParameterInfo> parameters() {
  const NodeOptions usual;
  std::vector<ParameterInfo> list;
  for (const Entry& entry : entries())
    list.push_back(
        {entry.name, type_of(entry.place), entry.unit, told(entry.place, usual), range_of(entry), entry.meaning});
  return list;
}

std::vector<std::pair<std::string, std::string>> parameters_without_use() {
  std::vector<std::pair<std::string, std::string>> list;
  for (const Unused& other : unused) list.emplace_back(other.name, other.why);
  return list;
}

NodeOptions options_from(const Values& values, std::vector<std::string>& warnings) {
  NodeOptions options;
  for (const auto& [name, value] : values) {
    if (const Alias* const alias = alias_of(name))
      choose_by(*alias, value, options);
    else if (const Entry* const entry = entry_of(name))
      choose(*entry, value, options);
    else if (const Unused* const other = unused_of(name))
      warnings.push_back("parameter '" + name + "' has no use here: " + other->why);
    else
      refuse_name(name);
  }
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "parameters");
  return options;
}

}  // namespace slamicp::node
