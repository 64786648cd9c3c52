// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp_node/messages.hpp>
#include <string>
#include <vector>

#include "cdr.hpp"

/// What was heard is what the node core said, to the last bit; else they throw.
/// @param at  " of scan 7", for what they throw
namespace slamicp::dds_peer {

bool operator==(const node::Position& a, const node::Position& b);
bool operator==(const node::Quaternion& a, const node::Quaternion& b);
bool operator==(const node::Stamp& a, const node::Stamp& b);

void must_agree(const Pose& pose, const node::Output& output, const std::string& at);
void must_agree(const node::Transform& map_to_odom, const node::Output& output, const std::string& at);
void must_agree(const Cloud& cloud, const std::vector<node::Point>& points, const std::string& frame,
                const std::string& at);
void must_agree(const Obstacles& obstacles, const node::Output& output, const std::string& at);
void must_agree(const std::vector<DrawnMarker>& markers, const node::Output& output, const std::string& at);
void must_agree(const Status& status, const node::Output& output, const std::string& at);

}  // namespace slamicp::dds_peer
