// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include <slamicp/error.hpp>
#include <slamicp/io/file_kind.hpp>

#include "io/log_format.hpp"
#include "io/text.hpp"
#include "io/world_yaml.hpp"

namespace slamicp {
namespace {

FileKind kind_of_csv(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error("cannot be read: " + std::string(std::strerror(errno)), path.string(), "check the name");
  std::string line;
  while (std::getline(file, line)) {
    const bool is_numbers = line.find_first_of("0123456789") != std::string::npos && line.front() != '#' &&
                            std::isalpha(static_cast<unsigned char>(line.front())) == 0;
    if (is_numbers) return std::count(line.begin(), line.end(), ',') > 2 ? FileKind::scan_log : FileKind::cloud;
  }
  return FileKind::cloud;
}

/// What cannot be read is told by who reads it.
FileKind kind_of_yaml(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line))
    if (is_world_yaml(line)) return FileKind::world;
  return FileKind::occupancy_map;
}

}  // namespace

FileKind kind_of(const std::filesystem::path& path) {
  const std::string ending = text::ending_of(path);
  if (ending != ".csv" && log_format(path)) return FileKind::scan_log;
  if (ending == ".xyz" || ending == ".pcd" || ending == ".ply") return FileKind::cloud;
  if (ending == ".yaml" || ending == ".yml") return kind_of_yaml(path);
  if (ending == ".pgm") return FileKind::occupancy_map;
  if (ending == ".csv") return kind_of_csv(path);
  throw Error("the ending '" + ending + "' is not one we read", path.string(),
              std::string("give a log (") + log_endings + ") or a cloud (.csv .xyz .pcd .ply)");
}

}  // namespace slamicp
