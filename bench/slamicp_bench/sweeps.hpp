// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "generated_scene.hpp"

namespace slamicp::bench {

/// A point of the abscissa.
struct Setting {
  double value = 0.0;
  std::string label;
  Recipe recipe;
  int threads = 1;
};

/// What is changed, and to what.
struct Sweep {
  std::string name;
  std::string axis;
  std::string unit;
  std::vector<Setting> settings;
  bool counts_scans = false;  ///< one scene; instead of each scan's time, scans a second are what matters
};

std::vector<std::string> sweep_names();
/// Throws std::out_of_range for a name that is none.
Sweep sweep_named(const std::string& name);

}  // namespace slamicp::bench
