// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>

namespace slamicp {

/// Opens a file that does not exist yet, for writing bytes. It may be removed while it is open, on Windows too, where
/// it is gone as soon as it is closed. Null and errno where it cannot.
std::FILE* open_new_file(const std::filesystem::path& path) noexcept;

}  // namespace slamicp
