// SPDX-License-Identifier: Apache-2.0
#include "fast_dds.hpp"

#include <algorithm>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <map>
#include <mutex>
#include <stdexcept>

namespace slamicp::dds_peer {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

/// A type whose messages are made elsewhere.
class BytesType : public dds::TopicDataType {
 public:
  explicit BytesType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 1U << 16U;
    m_isGetKeyDefined = false;
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<const Bytes*>(data);
    if (bytes.size() > payload->max_size) return false;
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    const char* const first = reinterpret_cast<const char*>(payload->data);
    static_cast<Bytes*>(data)->assign(first, first + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes(); }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void* /*data*/, rtps::InstanceHandle_t* /*handle*/, bool /*force_md5*/) override { return false; }
};

template <class Qos>
void choose(const Quality& quality, Qos& qos) {
  qos.reliability().kind = quality.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = quality.latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = quality.depth;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

template <class Entity>
Entity* made(Entity* entity, const std::string& what) {
  if (entity == nullptr) throw std::runtime_error("Fast DDS makes no " + what);
  return entity;
}

Guid guid_of(const rtps::InstanceHandle_t& handle) {
  const rtps::GUID_t guid = rtps::iHandle2GUID(handle);
  Guid bytes;
  std::copy_n(guid.guidPrefix.value, guid.guidPrefix.size, bytes.begin());
  std::copy_n(guid.entityId.value, guid.entityId.size, bytes.begin() + guid.guidPrefix.size);
  return bytes;
}

}  // namespace

/// What others say of themselves.
class Acquaintances : public dds::DomainParticipantListener {
 public:
  void on_participant_discovery(dds::DomainParticipant* /*we*/, rtps::ParticipantDiscoveryInfo&& found) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    user_data_[guid_of(rtps::InstanceHandle_t(found.info.m_guid))].assign(found.info.m_userData.begin(),
                                                                          found.info.m_userData.end());
  }
  std::string user_data(const Guid& participant) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = user_data_.find(participant);
    return found == user_data_.end() ? "" : found->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<Guid, std::string> user_data_;
};

struct FastDds::State {
  explicit State(std::uint32_t domain) {
    dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
    qos.name("slamicp_dds_peer");
    qos.transport().use_builtin_transports = false;  // the network alone, no shared memory
    qos.transport().user_transports.push_back(std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    participant = made(dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos, &acquaintances,
                                                                                         dds::StatusMask::none()),
                       "participant");
    publisher = made(participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT), "publisher");
    subscriber = made(participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT), "subscriber");
  }
  ~State() {
    participant->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  dds::Topic* topic(const std::string& name, const std::string& type) {
    dds::Topic*& topic = topics[name];
    if (topic != nullptr) return topic;
    const dds::TypeSupport support(new BytesType(type));
    support.register_type(participant);
    return topic = made(participant->create_topic(name, type, dds::TOPIC_QOS_DEFAULT), name);
  }

  Acquaintances acquaintances;
  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  std::map<std::string, dds::Topic*> topics;
};

FastDds::FastDds(std::uint32_t domain) : state_(std::make_shared<State>(domain)) {}
FastDds::~FastDds() = default;

FastDds::Writer FastDds::writer(const std::string& topic, const std::string& type, const Quality& quality) {
  dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
  choose(quality, qos);
  Writer writer;
  writer.writer_ = made(state_->publisher->create_datawriter(state_->topic(topic, type), qos), topic);
  return writer;
}

FastDds::Reader FastDds::reader(const std::string& topic, const std::string& type, const Quality& quality) {
  dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
  choose(quality, qos);
  Reader reader;
  reader.reader_ = made(state_->subscriber->create_datareader(state_->topic(topic, type), qos), topic);
  return reader;
}

std::string FastDds::user_data(const Guid& participant) const { return state_->acquaintances.user_data(participant); }

void FastDds::Writer::write(const Bytes& message) const {
  Bytes copy = message;
  if (!static_cast<dds::DataWriter*>(writer_)->write(&copy)) throw std::runtime_error("Fast DDS does not write");
}

bool FastDds::Writer::is_heard() const {
  dds::PublicationMatchedStatus status;
  static_cast<dds::DataWriter*>(writer_)->get_publication_matched_status(status);
  return status.current_count > 0;
}

int FastDds::Reader::speakers() const {
  dds::SubscriptionMatchedStatus status;
  static_cast<dds::DataReader*>(reader_)->get_subscription_matched_status(status);
  return status.current_count;
}

Guid FastDds::Writer::listener() const {
  dds::PublicationMatchedStatus status;
  static_cast<dds::DataWriter*>(writer_)->get_publication_matched_status(status);
  return guid_of(status.last_subscription_handle);
}

Guid FastDds::Reader::speaker() const {
  dds::SubscriptionMatchedStatus status;
  static_cast<dds::DataReader*>(reader_)->get_subscription_matched_status(status);
  return guid_of(status.last_publication_handle);
}

bool FastDds::Reader::wait(double seconds) const {
  return static_cast<dds::DataReader*>(reader_)->wait_for_unread_message(eprosima::fastrtps::Duration_t(seconds));
}

bool FastDds::Reader::take(Bytes& message) const {
  dds::SampleInfo info;
  while (static_cast<dds::DataReader*>(reader_)->take_next_sample(&message, &info) ==
         eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK)
    if (info.valid_data) return true;
  return false;
}

}  // namespace slamicp::dds_peer
