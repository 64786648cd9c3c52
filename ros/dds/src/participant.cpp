// SPDX-License-Identifier: Apache-2.0
#include "participant.hpp"

#include <memory>
#include <string_view>

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

/// What ROS 2 knows its own by: the security enclave, and "/" where there is none.
Qos ros_participant() {
  constexpr std::string_view enclave = "enclave=/;";
  Qos qos(dds_create_qos());
  dds_qset_userdata(qos.get(), enclave.data(), enclave.size());
  return qos;
}

std::string unheard_by(std::uint32_t policy) {
  if (policy == DDS_RELIABILITY_QOS_POLICY_ID) return "best effort, and is not heard: it must be reliable";
  if (policy == DDS_DURABILITY_QOS_POLICY_ID) return "volatile, and is not heard: it must be transient local";
  return "with less than we ask for, and is not heard";
}

Participant::Guid guid_of(dds_entity_t entity) {
  dds_guid_t guid;
  if (const dds_return_t result = dds_get_guid(entity, &guid); result < 0) throw Error(dds_strretcode(result), "DDS");
  return std::to_array(guid.v);
}

}  // namespace

Participant::Participant(std::uint32_t domain)
    : participant_(
          made(dds_create_participant(domain, ros_participant().get(), nullptr), "domain " + std::to_string(domain))),
      waitset_(made(dds_create_waitset(participant_), "waitset")) {}

Participant::~Participant() { dds_delete(participant_); }

dds_entity_t Participant::topic_of(const dds_topic_descriptor_t& type, const std::string& topic) {
  return made(dds_create_topic(participant_, &type, topic.c_str(), nullptr, nullptr), topic);
}

dds_entity_t Participant::reader(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) {
  const dds_entity_t reader =
      made(dds_create_reader(participant_, topic_of(type, "rt" + topic), qos_of(quality).get(), nullptr), topic);
  const dds_entity_t condition = made(dds_create_readcondition(reader, DDS_ANY_STATE), topic);
  made(dds_waitset_attach(waitset_, condition, 0), topic);
  readers_.push_back({reader, topic});
  return reader;
}

dds_entity_t Participant::writer(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) {
  writers_.push_back(plain_writer(type, "rt" + topic, quality));
  return writers_.back();
}

dds_entity_t Participant::plain_writer(const dds_topic_descriptor_t& type, const std::string& topic,
                                       const Quality& quality) {
  return made(dds_create_writer(participant_, topic_of(type, topic), qos_of(quality).get(), nullptr), topic);
}

void Participant::wait(double seconds) {
  dds_waitset_wait(waitset_, nullptr, 0, static_cast<dds_duration_t>(seconds * 1e9));
}

std::vector<std::string> Participant::unheard() const {
  std::vector<std::string> lines;
  for (const Reader& each : readers_) {
    dds_requested_incompatible_qos_status_t status;
    if (dds_get_requested_incompatible_qos_status(each.reader, &status) == DDS_RETCODE_OK &&
        status.total_count_change > 0)
      lines.push_back(each.topic + ": somebody publishes it " + unheard_by(status.last_policy_id));
  }
  return lines;
}

Participant::Guid Participant::guid() const { return guid_of(participant_); }

std::vector<Participant::Guid> Participant::readers() const {
  std::vector<Guid> guids;
  for (const Reader& each : readers_) guids.push_back(guid_of(each.reader));
  return guids;
}

std::vector<Participant::Guid> Participant::writers() const {
  std::vector<Guid> guids;
  for (const dds_entity_t each : writers_) guids.push_back(guid_of(each));
  return guids;
}

bool is_heard(dds_entity_t writer) {
  dds_publication_matched_status_t status;
  return dds_get_publication_matched_status(writer, &status) == DDS_RETCODE_OK && status.current_count > 0;
}

}  // namespace slamicp::node
