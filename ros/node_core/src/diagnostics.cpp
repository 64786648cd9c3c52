// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <slamicp_node/node.hpp>

#include "core.hpp"

namespace slamicp::node {
namespace {

enum Level { ok = 0, warning = 1, error = 2, stale = 3 };

std::string decimals(double value, int count) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", count, value);
  return text;
}

}  // namespace

const char* to_string(State state) {
  switch (state) {
    case State::waiting_for_map:
      return "waiting_for_map";
    case State::waiting_for_pose:
      return "waiting_for_pose";
    case State::waiting_for_scan:
      return "waiting_for_scan";
    case State::waiting_for_frames:
      return "waiting_for_frames";
    case State::waiting_for_odometry:
      return "waiting_for_odometry";
    case State::localizing:
      return "localizing";
    case State::recovering:
      return "recovering";
    case State::lost:
      return "lost";
    case State::mapping:
      return "mapping";
  }
  return "unknown";
}

State Node::state(Stamp now) const {
  const Core& core = *core_;
  if (!core.is_mapping() && !core.localizer) return State::waiting_for_map;
  if (!core.has_pose) return State::waiting_for_pose;
  if (!core.heard_scan || now.seconds() - core.last_scan > core.options.scan_timeout) return State::waiting_for_scan;
  if (!core.missing_frame.empty()) return State::waiting_for_frames;
  if (core.waits_for_odometry) return State::waiting_for_odometry;
  if (core.is_mapping()) return State::mapping;
  const Quality& quality = core.localizer->fix().quality;
  if (core.options.recover) return quality.doubted() ? State::recovering : State::localizing;
  return quality.state == TrackingState::lost ? State::lost : State::localizing;
}

Diagnostic Node::diagnostic(Stamp now) const {
  const Core& core = *core_;
  Diagnostic told;
  const State is = state(now);
  const Status& status = core.output.status;
  const bool runs = is == State::localizing || is == State::mapping;
  told.level = runs                            ? ok
               : is == State::waiting_for_scan ? (core.heard_scan ? stale : warning)
               : is == State::lost             ? error
                                               : warning;
  switch (is) {
    case State::waiting_for_map:
      told.message = core.options.use_map_topic ? "waits for a map on topic " + core.options.map_topic
                                                : "waits for the service static_map";
      break;
    case State::waiting_for_pose:
      told.message = "waits for a pose on topic initialpose";
      break;
    case State::waiting_for_scan:
      told.message = core.heard_scan ? "no scan for " + decimals(now.seconds() - core.last_scan, 1) + " s"
                                     : "no scan has come yet";
      break;
    case State::waiting_for_frames:
      told.message = "tf does not say where '" + core.missing_frame + "' sits on '" + core.options.base_frame_id + "'";
      break;
    case State::waiting_for_odometry:
      told.message = core.options.odom_topic.empty() ? "tf does not say where '" + core.options.base_frame_id +
                                                           "' is in '" + core.options.odom_frame_id + "'"
                                                     : "no odometry has come on " + core.options.odom_topic;
      break;
    case State::recovering:
      told.message = "the pose is " + status.tracking + ": looking around";
      break;
    case State::lost:
      told.message = "the pose is lost: give another one on initialpose";
      break;
    case State::mapping:
      told.message = core.mapping_is_over ? "the recording began again: the map stays as it is" : "mapping";
      break;
    case State::localizing:
      told.message = "localizing";
      break;
  }
  if (runs && core.has_output) {
    if (core.options.use_odometry && !status.had_odometry) {
      told.level = warning;
      told.message = "odometry does not reach the scans: going on by scans alone";
    } else if (core.frozen.frozen()) {
      told.level = warning;
      told.message = "odometry stands while the scans say that the robot goes";
    } else if (!status.usable) {
      told.level = warning;
      told.message = "the last scan does not fit the map: " + status.stop;
    }
  }
  const auto add = [&](const char* key, const std::string& value) { told.values.emplace_back(key, value); };
  add("state", to_string(is));
  if (core.has_output) {
    add("tracking", status.tracking);
    add("probability", decimals(status.probability, 3));
    add("map explains", decimals(status.awareness, 3));
    add("last match", status.stop);
    add("localization [ms]", decimals(1e3 * status.localization_seconds, 3));
    add("obstacles [ms]", decimals(1e3 * status.obstacle_seconds, 3));
  }
  add("scans", std::to_string(core.queue.taken()));
  add("scans dropped", std::to_string(core.queue.dropped() + core.without_frame));
  add("scans before map and pose", std::to_string(core.without_map));
  add("scans without odometry", std::to_string(core.without_odometry));
  add("odometry jumps", std::to_string(core.wheels.jumps()));
  add("odometry frozen", core.frozen.frozen() ? "yes" : "no");
  add("beams changed", std::to_string(core.queue.changes()));
  add("broken transforms", std::to_string(core.frames.broken()));
  add("time began again", std::to_string(core.restarts));
  add("maps", std::to_string(core.maps));
  add("recoveries", std::to_string(core.recoveries));
  return told;
}

}  // namespace slamicp::node
