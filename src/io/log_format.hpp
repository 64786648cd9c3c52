// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "io/compression.hpp"

namespace slamicp {

/// How a log is written.
struct LogFormat {
  enum class Kind { carmen, ranges_csv, ros1_bag, rosbag2, mcap };
  Kind kind = Kind::carmen;
  Compression compression = Compression::none;  ///< of a text log: "run.clf.gz"

  bool is_text() const noexcept { return kind == Kind::carmen || kind == Kind::ranges_csv; }
};

/// The endings of logs, for messages.
inline constexpr const char* log_endings = ".clf .log .csv (also .gz .xz .zst .bz2), .bag .db3 .mcap, a rosbag2 folder";

/// By the name's ending, or two of them; a folder is a rosbag2 if it has a metadata.yaml. Nothing where it is no log's
/// name. A `.csv` may as well be a cloud.
std::optional<LogFormat> log_format(const std::filesystem::path& path);

}  // namespace slamicp
