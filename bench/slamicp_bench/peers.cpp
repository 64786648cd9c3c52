// SPDX-License-Identifier: Apache-2.0
#include "peers.hpp"

#include <fstream>

#include <slamicp/error.hpp>

namespace slamicp::bench {
namespace {

constexpr const char* mend =
    "make it anew by bench/peers.py --json, with the same --map, --ranges, --poses and --scans";

void check_scene(const Json& told, const Scene& scene, const std::string& where) {
  const auto map_points = told.at("map_points").get<std::size_t>();
  const auto scans = told.at("scans").get<std::size_t>();
  const auto name = told.at("name").get<std::string>();
  if (map_points == scene.map->size() && scans == scene.trials.size() && name == scene.name) return;
  throw Error("measured on another scene: " + name + ", " + std::to_string(scans) + " scans, a map of " +
                  std::to_string(map_points) + " points; this one is " + scene.name + ", " +
                  std::to_string(scene.trials.size()) + " scans, " + std::to_string(scene.map->size()) + " points",
              where, mend);
}

}  // namespace

Peers load_peers(const std::filesystem::path& file, const Scene& scene) {
  std::ifstream in(file);
  if (!in) throw Error("cannot open the file", file.string(), mend);
  try {
    const Json json = Json::parse(in);
    check_scene(json.at("scene"), scene, file.string());
    Peers peers;
    for (const Json& row : json.at("contenders")) peers.rows.push_back(row_from(row));
    for (const Json& one : json.at("missing"))
      peers.missing.push_back(
          {one.at("name").get<std::string>(), one.at("why").get<std::string>(), one.at("mend").get<std::string>()});
    return peers;
  } catch (const Json::exception& problem) {
    throw Error(problem.what(), file.string(), mend);
  }
}

}  // namespace slamicp::bench
