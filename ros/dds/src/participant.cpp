// SPDX-License-Identifier: Apache-2.0
#include "participant.hpp"

#include <memory>

#include <slamicp/error.hpp>

namespace slamicp::node {
namespace {

/// The entity, or DDS's own word why there is none.
dds_entity_t made(dds_entity_t entity, const std::string& what) {
  if (entity < 0) throw Error(std::string("DDS: ") + dds_strretcode(entity), what);
  return entity;
}

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

Qos qos_of(const Quality& quality) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), quality.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));  // so long a writer waits for readers that are slow
  dds_qset_durability(qos.get(), quality.latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, quality.depth);
  if (quality.latched)  // what who comes late gets
    dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, quality.depth, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);  // our own tf
  return qos;
}

}  // namespace

Participant::Participant(std::uint32_t domain)
    : participant_(made(dds_create_participant(domain, nullptr, nullptr), "domain " + std::to_string(domain))),
      waitset_(made(dds_create_waitset(participant_), "waitset")) {}

Participant::~Participant() { dds_delete(participant_); }

dds_entity_t Participant::topic_of(const dds_topic_descriptor_t& type, const std::string& topic) {
  return made(dds_create_topic(participant_, &type, ("rt" + topic).c_str(), nullptr, nullptr), topic);
}

dds_entity_t Participant::reader(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) {
  const dds_entity_t reader =
      made(dds_create_reader(participant_, topic_of(type, topic), qos_of(quality).get(), nullptr), topic);
  const dds_entity_t condition = made(dds_create_readcondition(reader, DDS_ANY_STATE), topic);
  made(dds_waitset_attach(waitset_, condition, 0), topic);
  readers_.push_back({reader, topic});
  return reader;
}

dds_entity_t Participant::writer(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) {
  return made(dds_create_writer(participant_, topic_of(type, topic), qos_of(quality).get(), nullptr), topic);
}

void Participant::wait(double seconds) {
  dds_waitset_wait(waitset_, nullptr, 0, static_cast<dds_duration_t>(seconds * 1e9));
}

std::vector<std::string> Participant::unheard() const {
  std::vector<std::string> topics;
  for (const Reader& each : readers_) {
    dds_requested_incompatible_qos_status_t status;
    if (dds_get_requested_incompatible_qos_status(each.reader, &status) == DDS_RETCODE_OK &&
        status.total_count_change > 0)
      topics.push_back(each.topic);
  }
  return topics;
}

bool is_heard(dds_entity_t writer) {
  dds_publication_matched_status_t status;
  return dds_get_publication_matched_status(writer, &status) == DDS_RETCODE_OK && status.current_count > 0;
}

}  // namespace slamicp::node
