// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// The other vendor's DDS, by what the test needs of it: messages go in and out as bytes.
namespace slamicp::dds_peer {

using Bytes = std::vector<char>;  // a message in CDR, with its first four bytes
using Guid = std::array<std::uint8_t, 16>;

struct Quality {
  bool reliable = true, latched = false;
  int depth = 10;
};

class FastDds {
 public:
  class Writer;
  class Reader;

  explicit FastDds(std::uint32_t domain);
  ~FastDds();
  /// @param topic  "rt/scan"
  /// @param type   "sensor_msgs::msg::dds_::LaserScan_"
  Writer writer(const std::string& topic, const std::string& type, const Quality& quality);
  Reader reader(const std::string& topic, const std::string& type, const Quality& quality);
  /// What a participant that was discovered says of itself; empty: it is not known.
  std::string user_data(const Guid& participant) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

class FastDds::Writer {
 public:
  void write(const Bytes& message) const;
  bool is_heard() const;
  /// The reader that came last.
  Guid listener() const;

 private:
  friend class FastDds;
  void* writer_ = nullptr;
};

class FastDds::Reader {
 public:
  /// The next message; false: none has come.
  bool take(Bytes& message) const;
  /// Until there is a message to take; false: none has come for so many seconds.
  bool wait(double seconds) const;
  /// How many writers it hears; on a topic that we write, ourselves too.
  int speakers() const;
  /// The writer that came last.
  Guid speaker() const;

 private:
  friend class FastDds;
  void* reader_ = nullptr;
};

}  // namespace slamicp::dds_peer
