// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/io/output_file.hpp>

#include "io/new_file.hpp"
#include "io/text.hpp"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace slamicp {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

// Names of unfinished files. Whoever exchanges a name for nullptr owns it: so the signal handler never reads a string
// that a destructor frees at the same time.
using Character = fs::path::value_type;
using Name = fs::path::string_type;
std::array<std::atomic<const Character*>, 64> unfinished{};
static_assert(std::atomic<const Character*>::is_always_lock_free);

int enter(const Character* name) noexcept {
  for (std::size_t slot = 0; slot < unfinished.size(); ++slot) {
    const Character* expected = nullptr;
    if (unfinished[slot].compare_exchange_strong(expected, name)) return static_cast<int>(slot);
  }
  return -1;
}

/// False if the signal handler took the name first.
bool leave(int slot) noexcept {
  return slot < 0 || unfinished[static_cast<std::size_t>(slot)].exchange(nullptr) != nullptr;
}

/// Keeps a name that the signal handler holds: it may still be reading it.
void keep_for_handler(std::unique_ptr<Name> name) noexcept {
  static std::mutex mutex;
  static auto& kept = *new std::vector<std::unique_ptr<Name>>;  // never destroyed
  const std::lock_guard lock(mutex);
  kept.push_back(std::move(name));
}

void remove_by_name(const Character* name) noexcept {
#ifdef _WIN32
  _wunlink(name);
#else
  ::unlink(name);
#endif
}

std::FILE* open_existing(const fs::path& path) noexcept {
#ifdef _WIN32
  return _wfopen(path.c_str(), L"wb");
#else
  return std::fopen(path.c_str(), "wb");
#endif
}

/// Brings the bytes to the disk, so that a power cut after the rename finds the whole file. Best effort.
void sync(std::FILE* file) noexcept {
#ifdef _WIN32
  _commit(_fileno(file));
#else
  ::fsync(::fileno(file));
#endif
}

fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
#ifdef _WIN32
  const int process = _getpid();
#else
  const int process = static_cast<int>(::getpid());
#endif
  fs::path name = ".";
  name += target.filename();
  name += "." + std::to_string(process) + "-" + std::to_string(++count) + ".part";
  return target.parent_path() / name;
}

std::string mend_for(int cause, const fs::path& path) {
  if (cause == ENOENT) return "make the folder " + text::name_of(path.parent_path()) + " first, or name another";
  if (cause == EACCES || cause == EPERM || cause == EROFS) return "name a folder that you may write to";
  if (cause == ENOSPC) return "make room on the disk, or name a folder on another";
  return "name another file";
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), to_stdout_(path_ == "-") {
  if (to_stdout_) return;
  try {
    open();
  } catch (...) {
    give_up();
    throw;
  }
}

OutputFile::~OutputFile() { give_up(); }

void OutputFile::open() {
  std::error_code error;
  if (path_.empty()) throw Error("the output has no name", {}, "give a file name, or - for standard output");
  target_ = fs::weakly_canonical(path_, error);
  if (error || target_.empty()) target_ = path_;
  const fs::file_status status = fs::status(target_, error);
  if (fs::is_directory(status)) throw Error("is a folder", text::name_of(path_), "name a file in it");
  errno = 0;
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_ = open_existing(target_);
  } else {
    temporary_ = temporary_beside(target_);
    file_ = open_new_file(temporary_);
  }
  if (file_ == nullptr) {
    temporary_.clear();
    fail("cannot be written", errno);
  }
  if (!temporary_.empty()) {
    registered_ = std::make_unique<Name>(temporary_.native());
    slot_ = enter(registered_->c_str());
  }
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (!to_stdout_ && buffer_.size() >= buffer_size) flush();
}

void OutputFile::flush() {
  if (buffer_.empty()) return;
  errno = 0;
  std::FILE* const file = to_stdout_ ? stdout : file_;
  if (file == nullptr || std::fwrite(buffer_.data(), 1, buffer_.size(), file) != buffer_.size())
    fail("cannot be written to its end", errno);
  buffer_.clear();
}

void OutputFile::commit() {
#ifdef _WIN32
  if (to_stdout_) _setmode(_fileno(stdout), _O_BINARY);
#endif
  flush();
  errno = 0;
  if (to_stdout_) {
    if (std::fflush(stdout) != 0) fail("cannot be written to its end", errno);
    return;
  }
  if (file_ == nullptr) fail("was committed before", 0);
  if (std::fflush(file_) != 0) fail("cannot be written to its end", errno);
  if (!temporary_.empty()) sync(file_);
  if (std::fclose(std::exchange(file_, nullptr)) != 0) fail("cannot be written to its end", errno);
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail("cannot be given its name", error.value());
  temporary_.clear();
  if (!leave(std::exchange(slot_, -1))) keep_for_handler(std::move(registered_));
}

void OutputFile::give_up() noexcept {
  if (file_ != nullptr) std::fclose(std::exchange(file_, nullptr));
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  temporary_.clear();
  if (!leave(std::exchange(slot_, -1))) keep_for_handler(std::move(registered_));
}

void OutputFile::fail(const std::string& what, int cause) {
  give_up();
  buffer_.clear();
  const std::string reason = cause != 0 ? ": " + std::generic_category().message(cause) : std::string();
  throw Error(what + reason, to_stdout_ ? "standard output" : text::name_of(path_), mend_for(cause, target_));
}

void write_file(const fs::path& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

void remove_unfinished_outputs() noexcept {
  for (std::atomic<const Character*>& slot : unfinished)
    if (const Character* const name = slot.exchange(nullptr)) remove_by_name(name);
}

}  // namespace slamicp
