// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include <slamicp/error.hpp>
#include <slamicp/mapping/scan_odometry.hpp>

namespace slamicp {
namespace {

/// What both kinds of match have in common.
template <class Options>
Options match_of(const ScanOdometryOptions& options) {
  Options match;
  match.max_correspondence_distance = options.max_correspondence_distance;
  match.method = options.method;
  match.max_iterations = options.max_iterations;
  match.ranges = options.ranges;
  match.use_odometry = options.use_odometry;
  match.deskew = options.deskew;
  return match;
}

LocalizerOptions scan_to_scan(const ScanOdometryOptions& options) { return match_of<LocalizerOptions>(options); }

MapperOptions to_local_map(const ScanOdometryOptions& options) {
  MapperOptions mapper = match_of<MapperOptions>(options);
  mapper.insertion_distance = options.insertion_distance;
  mapper.forget_distance = options.map_radius;
  return mapper;
}

}  // namespace

std::string ScanOdometryOptions::problem() const {
  if (!(map_radius > 0.0)) return "map_radius must be a length above 0 m; 20 m is the default";
  if (reference == OdometryReference::previous_scan) return scan_to_scan(*this).problem();
  return to_local_map(*this).problem();
}

struct ScanOdometry::State {
  std::optional<Mapper> mapper;        // to the local map
  std::optional<Localizer> localizer;  // or scan to scan
  Trajectory trajectory;
  int unmatched = 0;
};

ScanOdometry::ScanOdometry(const ScanOdometryOptions& options) : state_(std::make_unique<State>()) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ScanOdometryOptions");
  if (options.reference == OdometryReference::previous_scan)
    state_->localizer.emplace(scan_to_scan(options));
  else
    state_->mapper.emplace(to_local_map(options));
}

ScanOdometry::~ScanOdometry() = default;
ScanOdometry::ScanOdometry(ScanOdometry&&) noexcept = default;
ScanOdometry& ScanOdometry::operator=(ScanOdometry&&) noexcept = default;

const Fix& ScanOdometry::add(const LaserScan& scan) {
  if (state_->mapper) return state_->mapper->add(scan);
  const Fix& fix = state_->localizer->update(scan);
  state_->trajectory.push_back({scan.stamp, fix.pose});
  if (!fix.usable() && state_->trajectory.size() > 1) ++state_->unmatched;
  return fix;
}

const Trajectory& ScanOdometry::trajectory() const noexcept {
  return state_->mapper ? state_->mapper->trajectory() : state_->trajectory;
}

int ScanOdometry::unmatched() const noexcept {
  return state_->mapper ? state_->mapper->unmatched() : state_->unmatched;
}

}  // namespace slamicp
