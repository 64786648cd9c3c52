// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>

#include "io/recording.hpp"

namespace slamicp::fuzz {

/// Wants every other topic, looks at every byte, and holds the reader to what it promised.
class Visitor : public RecordingVisitor {
 public:
  int open(const Channel&) override {
    const int channel = channels_++;
    return channel % 2 == 0 ? channel : -1;
  }
  void take(int channel, double, std::string_view body) override {
    if (channel < 0 || channel >= channels_ || channel % 2 != 0) std::abort();
    for (const char c : body) sum_ = sum_ + static_cast<unsigned char>(c);
  }
  void warn(const std::string& problem) override {
    if (problem.empty()) std::abort();
  }

 private:
  int channels_ = 0;
  volatile unsigned sum_ = 0;
};

}  // namespace slamicp::fuzz
