// SPDX-License-Identifier: Apache-2.0
#include "announcement.hpp"

#include <algorithm>
#include <messages.h>
#include <string_view>

#include <slamicp/error.hpp>

#include "lend.hpp"

namespace slamicp::node {
namespace {

struct FromIron {
  using Gid = rmw_dds_common_msg_dds__Gid_;
  using Node = rmw_dds_common_msg_dds__NodeEntitiesInfo_;
  using Message = rmw_dds_common_msg_dds__ParticipantEntitiesInfo_;
  static dds_topic_descriptor_t type() { return rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc; }
};

struct UntilHumble {
  using Gid = rmw_dds_common_msg_dds__until_humble_Gid_;
  using Node = rmw_dds_common_msg_dds__until_humble_NodeEntitiesInfo_;
  using Message = rmw_dds_common_msg_dds__until_humble_ParticipantEntitiesInfo_;
  static dds_topic_descriptor_t type() {
    dds_topic_descriptor_t type = rmw_dds_common_msg_dds__until_humble_ParticipantEntitiesInfo__desc;
    type.m_typename = FromIron::type().m_typename;
    return type;
  }
};

template <class Gid>
Gid gid_of(const Participant::Guid& guid) {
  Gid gid{};
  std::copy(guid.begin(), guid.end(), gid.data);
  return gid;
}

template <class Gid>
std::vector<Gid> gids_of(const std::vector<Participant::Guid>& guids) {
  std::vector<Gid> gids;
  gids.reserve(guids.size());
  for (const Participant::Guid& each : guids) gids.push_back(gid_of<Gid>(each));
  return gids;
}

template <class Types>
void announce_as(const Names& names, Participant& participant) {
  using Gid = typename Types::Gid;
  const std::vector<Gid> readers = gids_of<Gid>(participant.readers()), writers = gids_of<Gid>(participant.writers());
  std::vector<typename Types::Node> nodes(1);
  nodes.front().node_namespace = lend(names.space);
  nodes.front().node_name = lend(names.node);
  lend(readers, nodes.front().reader_gid_seq);
  lend(writers, nodes.front().writer_gid_seq);
  typename Types::Message message{};
  message.gid = gid_of<Gid>(participant.guid());
  lend(nodes, message.node_entities_info_seq);
  const std::string topic = "ros_discovery_info";
  const dds_topic_descriptor_t type = Types::type();
  const dds_entity_t writer = participant.plain_writer(type, topic, latched);
  if (const dds_return_t result = dds_write(writer, &message); result < 0) throw Error(dds_strretcode(result), topic);
}

}  // namespace

Spelling spelling_from(const char* distribution) {
  const std::string_view name = distribution == nullptr ? "" : distribution;
  const bool is_old = name == "foxy" || name == "galactic" || name == "humble";
  return is_old ? Spelling::until_humble : Spelling::from_iron;
}

void announce(const Names& names, Spelling spelling, Participant& participant) {
  if (spelling == Spelling::until_humble)
    announce_as<UntilHumble>(names, participant);
  else
    announce_as<FromIron>(names, participant);
}

}  // namespace slamicp::node
