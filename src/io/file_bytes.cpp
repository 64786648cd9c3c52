// SPDX-License-Identifier: Apache-2.0
#include "io/file_bytes.hpp"

#include "io/text.hpp"

#if defined(__unix__) || defined(__APPLE__)
#define SLAMICP_CAN_MAP
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace slamicp {

FileBytes::FileBytes(const std::filesystem::path& path) {
  if (map(path)) return;
  copy_ = text::read_file(path);
  bytes_ = copy_;
}

#ifdef SLAMICP_CAN_MAP

FileBytes::~FileBytes() {
  if (mapped_ != nullptr) ::munmap(mapped_, bytes_.size());
}

bool FileBytes::map(const std::filesystem::path& path) noexcept {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  struct stat facts {};
  if (::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_size > 0) {
    const auto size = static_cast<std::size_t>(facts.st_size);
    void* const start = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (start != MAP_FAILED) {
      mapped_ = start;
      bytes_ = {static_cast<const char*>(start), size};
    }
  }
  ::close(file);
  return mapped_ != nullptr;
}

#else

FileBytes::~FileBytes() = default;
bool FileBytes::map(const std::filesystem::path&) noexcept { return false; }

#endif

}  // namespace slamicp
