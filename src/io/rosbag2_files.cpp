// SPDX-License-Identifier: Apache-2.0
#include "io/rosbag2_files.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include <slamicp/error.hpp>

#include "io/text.hpp"

#ifdef SLAMICP_WITH_YAML
#include <yaml-cpp/yaml.h>
#endif

namespace slamicp {
namespace {

namespace fs = std::filesystem;

struct MetadataNames {
  std::vector<std::string> names;
  std::string problem;  ///< why there are none, in words
};

MetadataNames names_in_metadata(const fs::path& metadata) {
  MetadataNames found;
  std::error_code error;
  if (!fs::exists(metadata, error)) {
    found.problem = "has no metadata.yaml";
    return found;
  }
#ifdef SLAMICP_WITH_YAML
  try {
    const YAML::Node information = YAML::Load(text::read_file(metadata))["rosbag2_bagfile_information"];
    for (const YAML::Node& name : information["relative_file_paths"]) found.names.push_back(name.as<std::string>());
    if (found.names.empty()) found.problem = "its metadata.yaml names no files";
  } catch (const YAML::Exception& broken) {
    found.names.clear();
    found.problem = std::string("its metadata.yaml is broken (") + broken.what() + ")";
  }
#else
  found.problem = "this slamicp was built without yaml-cpp, which metadata.yaml needs";
#endif
  return found;
}

/// "bag_9.db3" before "bag_10.db3".
bool by_number(const std::string& a, const std::string& b) { return std::pair(a.size(), a) < std::pair(b.size(), b); }

std::vector<std::string> names_in_folder(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (!rosbag2_ending(entry.path()).empty()) names.push_back(text::name_of(entry.path().filename()));
  std::sort(names.begin(), names.end(), by_number);
  return names;
}

/// The file so named, or what became of it when it was packed or unpacked by hand. Old metadata names a folder too,
/// that of the time of recording.
fs::path find_rosbag2_file(const fs::path& folder, const std::string& name) {
  fs::path named = folder / fs::path(std::u8string(name.begin(), name.end())).filename();
  fs::path packed = named;
  packed += ".zstd";
  fs::path unpacked = named;
  unpacked.replace_extension();
  std::error_code error;
  if (fs::exists(named, error)) return named;
  if (fs::exists(packed, error)) return packed;
  return is_packed_rosbag2(named) && fs::exists(unpacked, error) ? unpacked : named;
}

}  // namespace

bool is_packed_rosbag2(const fs::path& file) {
  const std::string ending = text::ending_of(file);
  return ending == ".zstd" || ending == ".zst";
}

std::string rosbag2_ending(const fs::path& file) {
  const std::string ending = text::ending_of(is_packed_rosbag2(file) ? file.stem() : file);
  return ending == ".db3" || ending == ".mcap" ? ending : std::string();
}

bool is_rosbag2(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return is_packed_rosbag2(path) && !rosbag2_ending(path).empty();
  return fs::exists(path / "metadata.yaml", error) || !names_in_folder(path).empty();
}

std::vector<fs::path> rosbag2_files(const fs::path& folder, RecordingVisitor& visitor) {
  auto [names, problem] = names_in_metadata(folder / "metadata.yaml");
  if (names.empty()) {
    names = names_in_folder(folder);
    if (names.empty())
      throw Error("holds no rosbag2: " + problem + ", and there is no .db3 or .mcap file", text::name_of(folder),
                  "give the folder that ros2 bag wrote");
    visitor.warn(problem + ": its files are read in the order of their numbers");
  }
  std::vector<fs::path> files;
  files.reserve(names.size());
  for (const std::string& name : names) files.push_back(find_rosbag2_file(folder, name));
  return files;
}

}  // namespace slamicp
