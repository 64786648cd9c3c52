// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <utility>
#include <vector>

#include <slamicp/error.hpp>

#include "io/compression.hpp"
#include "io/file_bytes.hpp"
#include "io/recording.hpp"
#include "io/rosbag2_database.hpp"
#include "io/rosbag2_files.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_rosbag2_message = std::size_t{1} << 28;  ///< unpacked [bytes]
constexpr std::size_t largest_rosbag2_file = std::size_t{1} << 34;     ///< unpacked [bytes]

/// Stands between one file and the visitor: says which file a warning is of, and unpacks messages that were packed each
/// by itself. Those begin with Zstandard's magic, as no message in CDR does.
class Rosbag2FileVisitor : public RecordingVisitor {
 public:
  Rosbag2FileVisitor(std::string prefix, RecordingVisitor& visitor) : prefix_(std::move(prefix)), visitor_(visitor) {}

  int open(const Channel& channel) override {
    stopped_ = true;
    const int number = visitor_.open(channel);
    stopped_ = false;
    return number;
  }

  void take(int channel, double logged, std::string_view body) override {
    std::string unpacked;
    if (is_packed(Compression::zstd, body)) {
      try {
        unpacked = unpack(Compression::zstd, body, largest_rosbag2_message, "a message");
      } catch (const Error& error) {
        if (broken_++ == 0) problem_ = error.problem();
        return;
      }
      body = unpacked;
    }
    stopped_ = true;
    visitor_.take(channel, logged, body);
    stopped_ = false;
  }

  void warn(const std::string& problem) override {
    stopped_ = true;
    visitor_.warn(prefix_ + problem);
    stopped_ = false;
  }

  void tell() {
    if (broken_ > 0) warn(text::count_of(broken_, "message") + " cannot be unpacked (" + problem_ + "): left out");
  }

  /// True once the visitor has thrown.
  bool stopped() const noexcept { return stopped_; }

 private:
  std::string prefix_;
  RecordingVisitor& visitor_;
  std::size_t broken_ = 0;
  std::string problem_;
  bool stopped_ = false;
};

void read_rosbag2_file(const fs::path& file, Rosbag2FileVisitor& visitor) {
  const std::string name = text::name_of(file);
  const std::string ending = rosbag2_ending(file);
  const bool packed = is_packed_rosbag2(file);
  if (ending.empty())
    throw Error("is no file of rosbag2 that slamicp knows", name, "give .db3 or .mcap, as they are or with .zstd");
  if (ending == ".db3" && !packed) {
    read_rosbag2_database(file, visitor);
  } else {
    const FileBytes bytes(file);
    std::string unpacked =
        packed ? unpack(Compression::zstd, bytes.bytes(), largest_rosbag2_file, name) : std::string();
    if (ending == ".db3")
      read_rosbag2_database(std::move(unpacked), name, visitor);
    else
      read_mcap(packed ? unpacked : bytes.bytes(), name, visitor);
  }
  visitor.tell();
}

void read_rosbag2_folder(const fs::path& folder, RecordingVisitor& visitor) {
  const std::vector<fs::path> files = rosbag2_files(folder, visitor);
  std::vector<Error> errors;
  for (const fs::path& file : files) {
    Rosbag2FileVisitor of_file(text::name_of(file.filename()) + ": ", visitor);
    try {
      read_rosbag2_file(file, of_file);
    } catch (const Error& error) {
      if (of_file.stopped()) throw;
      errors.push_back(error);
    }
  }
  if (errors.size() == files.size()) throw errors.front();
  for (const Error& error : errors) visitor.warn(error.where() + ": " + error.problem() + ": left out");
}

}  // namespace

void read_rosbag2(const fs::path& path, RecordingVisitor& visitor) {
  std::error_code error;
  if (fs::is_directory(path, error)) return read_rosbag2_folder(path, visitor);
  Rosbag2FileVisitor of_file("", visitor);
  read_rosbag2_file(path, of_file);
}

}  // namespace slamicp
