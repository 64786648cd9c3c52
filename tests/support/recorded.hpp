// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/recording.hpp"

namespace slamicp::test {

/// Keeps all that a recording gives.
struct Recorded : RecordingVisitor {
  struct Message {
    std::string topic;
    double logged = 0.0;
    std::string body;

    friend bool operator==(const Message&, const Message&) = default;
  };

  int open(const Channel& channel) override {
    channels.push_back(channel);
    return unwanted.contains(channel.topic) ? -1 : static_cast<int>(channels.size()) - 1;
  }
  void take(int channel, double logged, std::string_view body) override {
    messages.push_back({channels.at(static_cast<std::size_t>(channel)).topic, logged, std::string(body)});
  }
  void warn(const std::string& problem) override { warnings.push_back(problem); }

  bool warned_of(std::string_view words) const {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
  }
  std::vector<std::string> bodies() const {
    std::vector<std::string> bodies;
    for (const Message& message : messages) bodies.push_back(message.body);
    return bodies;
  }

  std::set<std::string> unwanted;  ///< topics
  std::vector<Channel> channels;
  std::vector<Message> messages;
  std::vector<std::string> warnings;
};

}  // namespace slamicp::test
