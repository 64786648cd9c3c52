// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace slamicp {

/// Writes a whole file or none.
///
/// What is written goes to a hidden file beside the wanted one; `commit()` gives it its name in one step. Who never
/// commits (an exception, a Ctrl-C) leaves what was there before. The path "-" means standard output: there, too,
/// nothing appears before `commit()`. A device or a pipe is written directly.
class OutputFile {
 public:
  /// Throws Error where the file cannot be made: no such folder, no right to write.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Throws Error when the disk is full.
  void write(std::string_view bytes);

  /// Makes all that was written appear under its name. Throws Error; then nothing appears. Call it once, last.
  void commit();

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  void open();
  void flush();
  void give_up() noexcept;
  [[noreturn]] void fail(const std::string& what, int cause);

  std::filesystem::path path_;       ///< as the user named it
  std::filesystem::path target_;     ///< where it goes, links followed
  std::filesystem::path temporary_;  ///< empty where the target is written directly
  std::FILE* file_ = nullptr;
  std::string buffer_;
  /// Name of the temporary file as `remove_unfinished_outputs` sees it.
  std::unique_ptr<std::filesystem::path::string_type> registered_;
  int slot_ = -1;
  bool to_stdout_ = false;
};

/// Writes `content` as the whole file, or throws Error and leaves what was there.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Removes the hidden files of all outputs that are not committed (of 64 at a time). Safe to call from a signal
/// handler, once, right before the program ends.
void remove_unfinished_outputs() noexcept;

}  // namespace slamicp
