// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "field.hpp"
#include "row.hpp"
#include "scene.hpp"

namespace slamicp::bench {

/// What another program measured on the same scans (bench/peers.py).
struct Peers {
  std::vector<Row> rows;
  std::vector<Missing> missing;
};

/// Throws Error for a file that is not of that kind, or was measured on another scene.
Peers load_peers(const std::filesystem::path& file, const Scene& scene);

}  // namespace slamicp::bench
