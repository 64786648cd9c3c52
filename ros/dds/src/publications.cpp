// SPDX-License-Identifier: Apache-2.0
#include "publications.hpp"

#include <algorithm>
#include <slamicp_node/fields.hpp>
#include <slamicp_node/marker.hpp>

#include "conversions.hpp"
#include "lend.hpp"

namespace slamicp::node {
namespace {

char nothing[] = "";

/// The same as bytes.
template <class Sequence, class Element>
void lend_bytes(const std::vector<Element>& list, Sequence& sequence) {
  sequence._maximum = sequence._length = static_cast<std::uint32_t>(list.size() * sizeof(Element));
  sequence._buffer = reinterpret_cast<std::uint8_t*>(const_cast<Element*>(list.data()));
}

std_msgs_msg_dds__Header_ header(const Stamp& stamp, const std::string& frame) { return {to_dds(stamp), lend(frame)}; }

geometry_msgs_msg_dds__Quaternion_ to_dds(const Quaternion& turn) { return {turn.x, turn.y, turn.z, turn.w}; }

sensor_msgs_msg_dds__PointField_ field(const char* name, std::uint32_t offset) {
  constexpr std::uint8_t float32 = 7;  // sensor_msgs/PointField
  return {lend(name), offset, float32, 1};
}

slamicp_msgs_msg_dds__Obstacle_ to_dds(const Obstacle& obstacle) {
  slamicp_msgs_msg_dds__Obstacle_ told{};
  fill_numbers(obstacle, told);
  told.kind = lend(obstacle.kind);
  told.state = lend(obstacle.state);
  return told;
}

/// One that is deleted: all that it needs is its number.
visualization_msgs_msg_dds__Marker_ no_marker() {
  constexpr std::int32_t remove = 2;  // visualization_msgs/Marker
  visualization_msgs_msg_dds__Marker_ marker{};
  marker.action = remove;
  marker.pose.orientation.w = 1.0;
  marker.texture.header.frame_id = nothing;
  for (char** const text : {&marker.texture_resource, &marker.texture.format, &marker.text, &marker.mesh_resource,
                            &marker.mesh_file.filename})
    *text = nothing;
  return marker;
}

visualization_msgs_msg_dds__Marker_ to_dds(const Marker& drawn) {
  constexpr std::int32_t cube = 1, cylinder = 3, add = 0;
  visualization_msgs_msg_dds__Marker_ marker = no_marker();
  marker.type = drawn.is_round ? cylinder : cube;
  marker.action = add;
  marker.pose.position = {drawn.position.x, drawn.position.y, drawn.position.z};
  marker.pose.orientation = to_dds(drawn.orientation);
  marker.scale = {drawn.scale.x, drawn.scale.y, drawn.scale.z};
  marker.color = {drawn.red, drawn.green, drawn.blue, drawn.alpha};
  return marker;
}

}  // namespace

Publications::Publications(const NodeOptions& options, const Names& names, Participant& participant)
    : frame_(options.global_frame_id),
      name_(names.whole().substr(1) + ": localization"),
      logger_(names.whole().substr(1)),
      broadcasts_(options.tf_broadcast),
      pose_(participant.writer(geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, names.topic("amcl_pose"),
                               latched)),
      outliers_(participant.writer(sensor_msgs_msg_dds__PointCloud2__desc, names.topic("outliers"), usual)),
      inliers_(participant.writer(sensor_msgs_msg_dds__PointCloud2__desc, names.topic("inliers"), usual)),
      obstacles_(participant.writer(slamicp_msgs_msg_dds__Obstacles__desc, names.topic("obstacles"), usual)),
      markers_(
          participant.writer(visualization_msgs_msg_dds__MarkerArray__desc, names.topic("obstacle_markers"), usual)),
      status_(participant.writer(slamicp_msgs_msg_dds__Status__desc, names.topic("slamicp/status"), usual)),
      diagnostics_(
          participant.writer(diagnostic_msgs_msg_dds__DiagnosticArray__desc, names.topic("/diagnostics"), usual)),
      log_(participant.writer(rcl_interfaces_msg_dds__Log__desc, names.topic("/rosout"), logged)) {
  std::replace(logger_.begin(), logger_.end(), '/', '.');
  if (broadcasts_) tf_ = participant.writer(tf2_msgs_msg_dds__TFMessage__desc, names.topic("/tf"), motion);
  if (options.mode == "mapping" || !options.map_file.empty())
    map_ = participant.writer(nav_msgs_msg_dds__OccupancyGrid__desc, names.topic(options.map_topic), latched);
}

void Publications::publish(const Output& output) {
  if (broadcasts_ && output.has_transform) publish_transform(output);
  publish_pose(output);
  publish_cloud(outliers_, output.outliers, output);
  publish_cloud(inliers_, output.inliers, output);
  if (is_heard(obstacles_)) publish_obstacles(output);
  if (is_heard(markers_)) publish_markers(output);
  markers_shown_ = output.obstacles.size();
  publish(output.status, output.stamp);
}

void Publications::publish_transform(const Output& output) const {
  geometry_msgs_msg_dds__TransformStamped_ transform{};
  transform.header = header(output.transform_stamp, output.frame);
  transform.child_frame_id = lend(output.child);
  transform.transform.translation = {output.transform.x, output.transform.y, 0.0};
  transform.transform.rotation = to_dds(turn_by(output.transform.theta));
  tf2_msgs_msg_dds__TFMessage_ message{};
  message.transforms._maximum = message.transforms._length = 1;
  message.transforms._buffer = &transform;
  dds_write(tf_, &message);
}

void Publications::publish_pose(const Output& output) {
  geometry_msgs_msg_dds__PoseWithCovarianceStamped_ message{};
  message.header = header(output.stamp, frame_);
  message.pose.pose.position = {output.pose.x, output.pose.y, 0.0};
  message.pose.pose.orientation = to_dds(turn_by(output.pose.theta));
  std::copy(output.covariance.begin(), output.covariance.end(), message.pose.covariance);
  dds_write(pose_, &message);
}

void Publications::publish_cloud(dds_entity_t writer, const std::vector<Point>& points, const Output& output) const {
  static_assert(sizeof(Point) == 3 * sizeof(float), "a point is what the cloud's fields say");
  if (!is_heard(writer)) return;
  const std::vector<sensor_msgs_msg_dds__PointField_> fields{field("x", 0), field("y", 4), field("z", 8)};
  sensor_msgs_msg_dds__PointCloud2_ cloud{};
  cloud.header = header(output.stamp, output.scan_frame);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  lend(fields, cloud.fields);
  cloud.point_step = sizeof(Point);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = true;
  lend_bytes(points, cloud.data);
  dds_write(writer, &cloud);
}

void Publications::publish_obstacles(const Output& output) {
  std::vector<slamicp_msgs_msg_dds__Obstacle_> told;
  told.reserve(output.obstacles.size());
  for (const Obstacle& obstacle : output.obstacles) told.push_back(to_dds(obstacle));
  slamicp_msgs_msg_dds__Obstacles_ message{};
  message.header = header(output.stamp, frame_);
  lend(told, message.obstacles);
  dds_write(obstacles_, &message);
}

void Publications::publish_markers(const Output& output) {
  std::vector<visualization_msgs_msg_dds__Marker_> drawn;
  for (std::size_t k = 0; k < std::max(markers_shown_, output.obstacles.size()); ++k) {
    const bool is_there = k < output.obstacles.size();
    visualization_msgs_msg_dds__Marker_ marker = is_there ? to_dds(marker_of(output.obstacles[k])) : no_marker();
    marker.header = header(output.stamp, frame_);
    marker.ns = lend("obstacles");
    marker.id = static_cast<std::int32_t>(k);
    drawn.push_back(marker);
  }
  visualization_msgs_msg_dds__MarkerArray_ message{};
  lend(drawn, message.markers);
  dds_write(markers_, &message);
}

void Publications::publish(const Status& status, const Stamp& stamp) {
  if (!is_heard(status_)) return;
  slamicp_msgs_msg_dds__Status_ message{};
  message.header = header(stamp, frame_);
  fill_numbers(status, message);
  message.state = lend(to_string(status.state));
  message.tracking = lend(status.tracking);
  message.stop = lend(status.stop);
  message.carried_by = lend(status.carried_by);
  dds_write(status_, &message);
}

void Publications::publish(const Diagnostic& diagnostic, const Stamp& now) {
  std::vector<diagnostic_msgs_msg_dds__KeyValue_> values;
  values.reserve(diagnostic.values.size());
  for (const auto& [key, value] : diagnostic.values) values.push_back({lend(key), lend(value)});
  std::vector<diagnostic_msgs_msg_dds__DiagnosticStatus_> all(1);
  diagnostic_msgs_msg_dds__DiagnosticStatus_& status = all.front();
  status.level = static_cast<std::uint8_t>(diagnostic.level);
  status.name = lend(name_);
  status.message = lend(diagnostic.message);
  status.hardware_id = lend("none");
  lend(values, status.values);
  diagnostic_msgs_msg_dds__DiagnosticArray_ message{};
  message.header.stamp = to_dds(now);
  message.header.frame_id = nothing;
  lend(all, message.status);
  dds_write(diagnostics_, &message);
}

void Publications::publish(Severity severity, const std::string& line, const Stamp& now) {
  rcl_interfaces_msg_dds__Log_ message{};
  message.stamp = to_dds(now);
  message.level = static_cast<std::uint8_t>(severity);
  message.name = lend(logger_);
  message.msg = lend(line);
  message.file = message.function = nothing;
  dds_write(log_, &message);
}

void Publications::publish(const Grid& grid) {
  nav_msgs_msg_dds__OccupancyGrid_ message{};
  message.header = header(grid.stamp, grid.frame);
  message.info.map_load_time = message.header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position = {grid.origin.x, grid.origin.y, grid.origin.z};
  message.info.origin.orientation = to_dds(grid.orientation);
  lend_bytes(grid.cells, message.data);
  dds_write(map_, &message);
}

}  // namespace slamicp::node
