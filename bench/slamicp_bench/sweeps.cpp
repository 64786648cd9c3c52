// SPDX-License-Identifier: Apache-2.0
#include "sweeps.hpp"

#include <map>

#include "measure/support.hpp"

namespace slamicp::bench {
namespace {

using measure::text;

template <class Change>
std::vector<Setting> settings(std::initializer_list<double> values, Change change) {
  std::vector<Setting> all;
  for (const double value : values) {
    Setting setting{value, text("%g", value), {}};
    change(setting.recipe, value);
    all.push_back(setting);
  }
  return all;
}

Sweep map_size() {
  return {"map-size", "map points", "",
          settings({1e3, 1e4, 1e5, 1e6, 1e7}, [](Recipe& r, double v) { r.map_points = v; })};
}

Sweep layouts() {
  Sweep sweep{"layout", "layout", "", {}};
  for (const LayoutKind kind : {LayoutKind::corridor, LayoutKind::office, LayoutKind::hall}) {
    Recipe recipe;
    recipe.layout = kind;
    sweep.settings.push_back({static_cast<double>(kind), to_string(kind), recipe});
  }
  return sweep;
}

Sweep beams() {
  return {"beams", "beams", "",
          settings({180, 360, 720, 1081, 2000, 4000}, [](Recipe& r, double v) { r.beams = static_cast<int>(v); })};
}

Sweep outliers() {
  return {"outliers", "outlier share", "%",
          settings({0, 10, 20, 30, 40, 50, 60}, [](Recipe& r, double v) { r.outlier_share = v / 100.0; })};
}

Sweep guess() {
  return {"guess", "guess error, 1 sigma in x and in y, and 2 deg", "cm",
          settings({1, 2, 5, 10, 20, 30, 50}, [](Recipe& r, double v) { r.guess_sigma = v / 100.0; })};
}

Sweep threads() {
  Sweep sweep{"threads", "threads", "", {}, true};
  for (const int count : {1, 2}) sweep.settings.push_back({static_cast<double>(count), text("%d", count), {}, count});
  return sweep;
}

const std::map<std::string, Sweep (*)()>& sweeps() {
  static const std::map<std::string, Sweep (*)()> all{{"map-size", map_size}, {"layout", layouts},
                                                      {"beams", beams},       {"outliers", outliers},
                                                      {"guess", guess},       {"threads", threads}};
  return all;
}

}  // namespace

std::vector<std::string> sweep_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : sweeps()) names.push_back(name);
  return names;
}

Sweep sweep_named(const std::string& name) { return sweeps().at(name)(); }

}  // namespace slamicp::bench
