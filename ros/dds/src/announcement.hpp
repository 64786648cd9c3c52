// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "names.hpp"
#include "participant.hpp"

namespace slamicp::node {

/// How the machines' ROS 2 spells who is who (rmw_dds_common): an identity has 24 bytes until Humble, 16 from Iron on.
/// Who hears the other spelling sees our topics, and no node.
enum class Spelling { from_iron, until_humble };
/// Of ROS_DISTRO: "foxy", "galactic" and "humble" are the older ones; null, empty or another: from_iron.
Spelling spelling_from(const char* distribution);

/// Tells ROS 2 machines that the participant is a node of this name, which all its readers and writers belong to: then
/// `ros2 node list` has it. Once they are all made.
void announce(const Names& names, Spelling spelling, Participant& participant);

}  // namespace slamicp::node
