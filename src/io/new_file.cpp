// SPDX-License-Identifier: Apache-2.0
#include "io/new_file.hpp"

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#endif

namespace slamicp {

#ifdef _WIN32

std::FILE* open_new_file(const std::filesystem::path& path) noexcept {
  const HANDLE handle = CreateFileW(path.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    const DWORD cause = GetLastError();
    errno = cause == ERROR_PATH_NOT_FOUND || cause == ERROR_FILE_NOT_FOUND ? ENOENT
            : cause == ERROR_DISK_FULL                                     ? ENOSPC
                                                                           : EACCES;
    return nullptr;
  }
  const int descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY);
  if (descriptor < 0) {
    CloseHandle(handle);
    return nullptr;
  }
  std::FILE* const file = _fdopen(descriptor, "wb");
  if (file == nullptr) _close(descriptor);
  return file;
}

#else

std::FILE* open_new_file(const std::filesystem::path& path) noexcept { return std::fopen(path.c_str(), "wbx"); }

#endif

}  // namespace slamicp
