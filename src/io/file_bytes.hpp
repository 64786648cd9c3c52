// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace slamicp {

/// All bytes of a file, to read. Where the system can, a file is mapped: only what is looked at takes memory, and files
/// larger than it are fine. It must not become shorter meanwhile.
class FileBytes {
 public:
  /// Throws Error where it cannot be read.
  explicit FileBytes(const std::filesystem::path& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  /// Good as long as this lives.
  std::string_view bytes() const noexcept { return bytes_; }

 private:
  bool map(const std::filesystem::path& path) noexcept;

  std::string_view bytes_;
  std::string copy_;  ///< of what cannot be mapped: pipes, empty files
  void* mapped_ = nullptr;
};

}  // namespace slamicp
