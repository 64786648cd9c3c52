// SPDX-License-Identifier: Apache-2.0
#include "io/log_format.hpp"

#include <string>

#include "io/rosbag2_files.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

std::optional<LogFormat::Kind> kind_of_ending(const std::string& ending) {
  if (ending == ".clf" || ending == ".log") return LogFormat::Kind::carmen;
  if (ending == ".csv") return LogFormat::Kind::ranges_csv;
  if (ending == ".bag") return LogFormat::Kind::ros1_bag;
  if (ending == ".db3") return LogFormat::Kind::rosbag2;
  if (ending == ".mcap") return LogFormat::Kind::mcap;
  return std::nullopt;
}

}  // namespace

std::optional<LogFormat> log_format(const std::filesystem::path& path) {
  if (is_rosbag2(path)) return LogFormat{LogFormat::Kind::rosbag2};
  const std::string ending = text::ending_of(path);
  if (const auto kind = kind_of_ending(ending)) return LogFormat{*kind};
  const auto inner = kind_of_ending(text::ending_of(path.stem()));
  if (!inner) return std::nullopt;
  // A bag that is still recorded, or was never closed.
  if (ending == ".active" && *inner == LogFormat::Kind::ros1_bag) return LogFormat{*inner};
  const LogFormat packed{*inner, compression_of_ending(ending)};
  if (packed.compression == Compression::none || !packed.is_text()) return std::nullopt;
  return packed;
}

}  // namespace slamicp
