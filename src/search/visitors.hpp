// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include <slamicp/search/neighbour.hpp>

namespace slamicp {

// What a search keeps of the points it sees. A search need not show a point farther than bound(), which only falls.

/// True if (distance, id) comes before `best`: nearer, or as near and of a lower index.
inline bool before(double squared_distance, int id, const Neighbour& best) noexcept {
  return squared_distance < best.squared_distance || (squared_distance == best.squared_distance && id < best.index);
}

struct NearestVisitor {
  double reach2;
  Neighbour best{};

  double bound() const noexcept { return std::min(best.squared_distance, reach2); }
  void see(int id, double squared_distance) noexcept {
    if (squared_distance < reach2 && before(squared_distance, id, best)) best = {id, squared_distance};
  }
};

struct NearestTwoVisitor {
  double reach2;
  Neighbour best{};
  double second = std::numeric_limits<double>::infinity();

  double bound() const noexcept { return std::min(second, reach2); }
  void see(int id, double squared_distance) noexcept {
    if (!(squared_distance < reach2)) return;
    if (before(squared_distance, id, best)) {
      second = best.squared_distance;
      best = {id, squared_distance};
    } else {
      second = std::min(second, squared_distance);
    }
  }
};

struct NearestKVisitor {
  double reach2;
  std::span<Neighbour> found;
  std::size_t count;

  double bound() const noexcept {
    return count < found.size() ? reach2 : std::min(reach2, found.back().squared_distance);
  }
  void see(int id, double squared_distance) noexcept {
    if (!(squared_distance < reach2)) return;
    if (count == found.size() && !before(squared_distance, id, found.back())) return;
    std::size_t place = count < found.size() ? count++ : count - 1;
    for (; place > 0 && before(squared_distance, id, found[place - 1]); --place) found[place] = found[place - 1];
    found[place] = {id, squared_distance};
  }
};

struct WithinVisitor {
  double reach2;
  std::vector<int>& indices;

  double bound() const noexcept { return reach2; }
  void see(int id, double squared_distance) {
    if (squared_distance < reach2) indices.push_back(id);
  }
};

}  // namespace slamicp
