// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <slamicp/obstacles/find_obstacles.hpp>

namespace slamicp {

/// What a run gives reason to change in a map. Somebody has to agree: nothing here edits a map.
struct ProposedChange {
  enum class Kind : unsigned char {
    add,     ///< something stands there, and has all the while
    remove,  ///< rays went through what the map has there
  };
  Kind kind = Kind::add;
  OrientedBox box;             ///< around it, in the map's frame
  PointCloud2 points;          ///< to add: where it was seen, one a cell; to remove: the map's points [m]
  std::vector<int> map_index;  ///< to remove: their numbers in the map, rising; else empty
  int scans = 0;               ///< that say so, of the part that most scans looked at
  double share = 0.0;          ///< of the rays that speak for it, of all that speak of it, 0 .. 1
  double first_stamp = 0.0;    ///< when it was first seen so [s]
  double last_stamp = 0.0;     ///< and last
  double baseline = 0.0;       ///< how far apart the places are that it was seen from [m]

  /// "add 0.80 m x 0.30 m at 9.00 m, 0.40 m: 57 scans, 12.3 s, seen from places 4.1 m apart, 100 % agree"
  std::string brief() const;
};

/// "add", "remove"
const char* to_string(ProposedChange::Kind kind) noexcept;

struct MapChangeOptions {
  double cell = 0.05;         ///< what evidence is gathered in [m], above 0
  double interval = 0.2;      ///< between the scans that are looked at [s], at least 0
  int min_scans = 8;          ///< that must have seen it, at least 1
  double min_seconds = 3.0;   ///< from first to last, at least 0; who walks is gone by then
  double min_baseline = 0.5;  ///< between the places that saw it [m], at least 0; no single view is believed
  double min_share = 0.8;     ///< of the rays must agree, in (0.5, 1]
  double min_size = 0.15;     ///< smaller things are left alone [m], at least 0

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Gathers, over a run, what stands where the map has nothing and which mapped walls rays go through, in cells, with
/// what speaks against it: rays that pass where something stood before, rays that end at the wall. (A count instead of
/// the survival probability of Rosen, Mason, Leonard 2016, "Towards lifelong feature-based mapping in semi-static
/// environments": a run is short, and a count can be shown to whoever decides.)
///
/// All fixes must be in one map. Scans whose fix is not trusted (TrackingState::tracking) count for nothing. Who stands
/// still all the while is proposed as any other thing. Allocates.
class MapChanges {
 public:
  /// Throws Error with options.problem().
  explicit MapChanges(const MapChangeOptions& options = {});

  /// About a millisecond for each scan that is looked at.
  void add(const Fix& fix, const LaserScan& scan, std::span<const Obstacle> obstacles);

  /// Largest first, what to add before what to remove.
  std::vector<ProposedChange> proposals() const;

 private:
  struct Evidence {
    int scans = 0;    // that speak for it
    int last = -1;    // the last one of these
    int rays = 0;     // that speak for it
    int against = 0;  // rays
    Vector<2> sum = Vector<2>::Zero();
    double first_stamp = 0.0;
    double last_stamp = 0.0;
    Bounds<2> lasers;
  };
  using Cells = std::unordered_map<std::uint64_t, Evidence>;

  std::uint64_t key_of(const Point2& place) const noexcept;
  void speak_for(Cells& cells, const Point2& place, const Point2& laser, double stamp);
  void pass_along(const Point2& from, const Vector<2>& direction, double until);
  std::vector<ProposedChange> grouped(const Cells& cells, ProposedChange::Kind kind) const;
  bool is_sure(const Evidence& evidence) const noexcept;

  MapChangeOptions options_;
  Cells new_;   // where something stands that the map has not
  Cells gone_;  // where rays went through mapped walls
  PointMap2::Pointer map_;
  int scans_ = 0;
  double next_ = -std::numeric_limits<double>::infinity();  // stamp of the next scan to look at
};

}  // namespace slamicp
