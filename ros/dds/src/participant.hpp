// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <dds/dds.h>
#include <string>
#include <vector>

namespace slamicp::node {

/// What a topic promises or asks for, in ROS 2's words. What does not match is not heard.
struct Quality {
  bool reliable = true;
  bool latched = false;  ///< ROS 2: transient local; who comes late gets the last message too
  int depth = 10;        ///< ROS 2: keep last
};
constexpr Quality sensor_data{false, false, 100};  // ROS 2 keeps 5: how many is the reader's own business
constexpr Quality usual{};
constexpr Quality motion{true, false, 100};
constexpr Quality latched_motion{true, true, 100};
constexpr Quality latched{true, true, 1};
constexpr Quality logged{true, true, 100};  // ROS 2 keeps 1,000 for 10 s

/// One who takes part in a DDS domain. Throws slamicp::Error where DDS refuses.
class Participant {
 public:
  explicit Participant(std::uint32_t domain);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// @param topic  absolute, as ROS 2 names it: "/scan"
  dds_entity_t reader(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality);
  dds_entity_t writer(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality);
  /// One of a topic that is none of ROS 2's: its name goes out as it stands.
  dds_entity_t plain_writer(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality);
  /// Until a message has come for a reader, or so long.
  void wait(double seconds);
  /// Who has come since the last call and promises less than we ask for, in words.
  std::vector<std::string> unheard() const;

  using Guid = std::array<std::uint8_t, 16>;
  /// Who it is on the wire, and who its readers and writers of ROS 2's topics are.
  Guid guid() const;
  std::vector<Guid> readers() const;
  std::vector<Guid> writers() const;

 private:
  dds_entity_t topic_of(const dds_topic_descriptor_t& type, const std::string& topic);

  dds_entity_t participant_;
  dds_entity_t waitset_;
  std::vector<dds_entity_t> writers_;
  struct Reader {
    dds_entity_t reader;
    std::string topic;
  };
  std::vector<Reader> readers_;
};

/// Calls use(message) for each that has come.
template <class Message, class Use>
void take_all(dds_entity_t reader, const Use& use) {
  void* sample = nullptr;  // lent
  dds_sample_info_t info;
  while (dds_take(reader, &sample, &info, 1, 1) > 0) {
    if (info.valid_data) use(*static_cast<const Message*>(sample));
    dds_return_loan(reader, &sample, 1);
    sample = nullptr;
  }
}

/// Whether anybody listens.
bool is_heard(dds_entity_t writer);

}  // namespace slamicp::node
