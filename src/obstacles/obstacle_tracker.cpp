// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>

#include "obstacles/assignment.hpp"
#include "obstacles/followed.hpp"
#include "obstacles/people.hpp"

namespace slamicp {
namespace {

constexpr double seconds_between_tests = 0.1;
constexpr double foot_spread = 0.22;   // of one foot around the middle of both, 1 sigma [m]
constexpr double fastest = 3.0;        // that a thing is while nobody sees it, a swinging leg too [m/s]
constexpr double farthest_jump = 1.2;  // between where a thing is thought and where it is seen [m]
constexpr double nearest_jump = 0.2;   // that it may always make [m]
constexpr double first_speed = 1.2;    // of what is new, 1 sigma [m/s]

/// Above all costs of pairs.
double cost_of_none(const ObstacleTrackerOptions& options) noexcept { return options.gate + 20.0; }

/// How far a detection may be off what it is of: of somebody one foot only may be seen.
Matrix<2, 2> spread_of(const Followed& it, const Detection& seen) noexcept {
  if (!it.is_person()) return Matrix<2, 2>::Zero();
  return round_noise(seen.width > widest_leg ? 0.5 * foot_spread : foot_spread);
}

ViewErrors errors_of(const Fix& fix) noexcept {
  const double position = std::sqrt(std::max(0.0, std::max(fix.covariance(0, 0), fix.covariance(1, 1))));
  const double turn = std::sqrt(std::max(0.0, fix.covariance(2, 2)));
  constexpr double sure = 3.0 * 1.4142;  // three sigma of the difference of two fixes
  ViewErrors errors;
  errors.margin += sure * position;
  errors.shift += sure * position;
  errors.turn += sure * turn;
  return errors;
}

}  // namespace

std::string ObstacleTrackerOptions::problem() const {
  if (confirmations < 1) return "confirmations must be at least 1";
  if (!(confirm_within > 0.0)) return "confirm_within must be above 0 s";
  if (!(patience > 0.0)) return "patience must be above 0 s";
  if (!(hidden_patience >= patience)) return "hidden_patience must be at least patience";
  if (!(settle > 0.0)) return "settle must be above 0 s";
  if (!(least_motion > 0.0)) return "least_motion must be above 0 m";
  if (!(agility > 0.0)) return "agility must be above 0 m^2/s^3; 0.5 suits people";
  if (!(gate > 0.0)) return "gate must be above 0; 9.21 leaves out one in a hundred";
  if (most_tracks < 1 || most_tracks > 1000) return "most_tracks must be from 1 to 1000";
  return {};
}

struct ObstacleTracker::State {
  explicit State(const ObstacleTrackerOptions& given);

  void predict(double seconds) noexcept;
  void take_detections(const Fix& fix, const LaserScan& scan, std::span<const Obstacle> obstacles) noexcept;
  void assign() noexcept;
  void allow(std::size_t row, const Followed& it, std::size_t detection) noexcept;
  void see(Followed& it) noexcept;
  void miss(Followed& it, const LaserView& now, bool knows_where) const noexcept;
  void name(Followed& it) const noexcept;
  void begin() noexcept;
  void test(const LaserView& now, const ViewErrors& errors) noexcept;
  void keep_view(const LaserView& now) noexcept;
  bool is_over(const Followed& it) const noexcept;
  void show() noexcept;

  ObstacleTrackerOptions options;
  std::vector<Followed> followed;  // in order of their id
  std::vector<Detection> detections;
  std::vector<std::array<int, 2>> seen_as;  // of each track, detections; -1: none
  std::vector<std::size_t> track_of_row;
  std::vector<char> taken;  // detections
  Assignment assignment;
  PastViews views;
  std::vector<Track> shown;
  Pose2 last_pose;
  double stamp = 0.0;
  double next_pairing = 0.0;
  bool started = false;
  int next_id = 1;
};

ObstacleTracker::State::State(const ObstacleTrackerOptions& given) : options(given) {
  const auto most = static_cast<std::size_t>(options.most_tracks);
  followed.reserve(most);
  detections.reserve(most);
  seen_as.reserve(most);
  track_of_row.reserve(2 * most);
  taken.reserve(most);
  shown.reserve(most);
  assignment.reserve(2 * most, most);
}

void ObstacleTracker::State::predict(double seconds) noexcept {
  for (Followed& it : followed) {
    it.motion.predict(seconds, agility_of(it, options));
    it.shown.obstacles = {-1, -1};
  }
}

void ObstacleTracker::State::take_detections(const Fix& fix, const LaserScan& scan,
                                             std::span<const Obstacle> obstacles) noexcept {
  detections.clear();
  for (std::size_t k = 0; k < obstacles.size() && detections.size() < detections.capacity(); ++k)
    if (!obstacles[k].points.empty()) detections.push_back(detect(fix, scan, obstacles[k], static_cast<int>(k)));
  taken.assign(detections.size(), 0);
}

/// Lets a row of the assignment have a detection, if it may be of its track. Of two that could be, the likelier one:
/// the cost is minus twice the logarithm of the density, constants left out.
void ObstacleTracker::State::allow(std::size_t row, const Followed& it, std::size_t detection) noexcept {
  const Detection& seen = detections[detection];
  const Vector<2> off = seen.middle - it.motion.position;
  const double jump = std::min(farthest_jump, nearest_jump + fastest * (stamp - it.shown.last_seen));
  if (off.squaredNorm() > jump * jump) return;
  if (it.is_person() && seen.width > 1.25 * widest_person) return;
  const Matrix<2, 2> expected = it.motion.of_position + seen.noise + spread_of(it, seen);
  const double determinant = expected.determinant();
  if (!(determinant > 0.0)) return;
  const double distance2 = off.dot(expected.inverse() * off);
  if (distance2 > options.gate) return;
  double cost = distance2 + std::log(determinant);
  if (!it.is_person()) {
    const double unlike = (seen.width - it.shown.width) / (0.2 + 0.5 * std::max(seen.width, it.shown.width));
    cost += unlike * unlike;
  }
  assignment.allow(row, detection, std::min(cost, cost_of_none(options) - 1.0));
}

void ObstacleTracker::State::assign() noexcept {
  track_of_row.clear();
  for (std::size_t k = 0; k < followed.size(); ++k)
    for (int row = 0; row < (followed[k].is_person() ? 2 : 1); ++row) track_of_row.push_back(k);
  assignment.start(track_of_row.size(), detections.size());
  for (std::size_t row = 0; row < track_of_row.size(); ++row)
    for (std::size_t d = 0; d < detections.size(); ++d) allow(row, followed[track_of_row[row]], d);
  const std::span<const int> columns = assignment.solve(cost_of_none(options));
  seen_as.assign(followed.size(), {-1, -1});
  for (std::size_t row = 0; row < columns.size(); ++row) {
    if (columns[row] < 0) continue;
    taken[static_cast<std::size_t>(columns[row])] = 1;
    std::array<int, 2>& as = seen_as[track_of_row[row]];
    as[as[0] < 0 ? 0 : 1] = columns[row];
  }
}

/// Corrects a track by what it was seen as, in this scan.
void ObstacleTracker::State::see(Followed& it) noexcept {
  const std::array<int, 2>& as = seen_as[static_cast<std::size_t>(&it - followed.data())];
  const Detection& first = detections[static_cast<std::size_t>(as[0])];
  it.shown.obstacles[0] = first.obstacle;
  it.footprint = first.footprint;
  it.is_part = first.is_part;
  double width = first.width;
  if (as[1] >= 0) {
    const Detection& second = detections[static_cast<std::size_t>(as[1])];
    it.shown.obstacles[1] = second.obstacle;
    it.motion.correct(0.5 * (first.middle + second.middle), first.noise + round_noise(0.02));
    width = (first.middle - second.middle).norm() + 0.5 * (first.width + second.width);
    if (second.footprint.count > it.footprint.count) it.footprint = second.footprint;
  } else {
    it.motion.correct(first.middle, first.noise + spread_of(it, first));
  }
  it.width = width;
  constexpr double newest = 0.15;
  it.shown.width += newest * (width - it.shown.width);
  it.leg_share += newest * ((first.is_leg ? 1.0 : 0.0) - it.leg_share);
  it.shown.last_seen = stamp;
  ++it.shown.scans;
  if (it.shown.state == TrackState::tentative) {
    if (it.shown.scans >= options.confirmations) it.shown.state = TrackState::confirmed;
  } else {
    it.shown.state = TrackState::confirmed;
  }
}

/// It was not seen: how long to wait for it depends on what the laser sees of its place.
void ObstacleTracker::State::miss(Followed& it, const LaserView& now, bool knows_where) const noexcept {
  ++it.missed;
  if (it.shown.state == TrackState::confirmed) it.shown.state = TrackState::hidden;
  constexpr double margin = 0.15;
  const Sight sight = knows_where ? now.look(it.motion.position, margin, 0.0, 0.0) : Sight::unseen;
  const bool not_to_be_seen = sight == Sight::hidden || sight == Sight::unseen;
  // Something is there: the map's wall, or what another track was seen as.
  const double between = 0.5 * (options.patience + options.hidden_patience);
  constexpr double soon = 0.15;                                            // [s]
  if (!it.moves() && stamp - it.shown.last_seen > soon) it.motion.halt();  // where to it might go is not known
  if (it.shown.motion == TrackMotion::undecided) {
    it.patience = options.patience;
    return;
  }
  it.patience = sight == Sight::free ? options.patience : not_to_be_seen ? options.hidden_patience : between;
}

/// What it is, by its size and motion. Of what has moved and is no wider than somebody, one leg is seen, or both.
void ObstacleTracker::State::name(Followed& it) const noexcept {
  constexpr double least_walk = 0.3;  // [m]
  if (it.moves()) {
    if (!it.ever_moved) it.set_out = it.motion.position;
    it.reached = std::max(it.reached, (it.motion.position - it.set_out).norm());
  } else if (it.ever_moved && it.shown.motion == TrackMotion::still && it.reached < least_walk) {
    it.ever_moved = false;  // it jumped once, as what comes into view does: nobody walks like that
    it.shown.kind = TrackKind::thing;
  }
  if (it.is_person()) return;
  if (!it.moves() && !it.ever_moved) {
    const bool is_alone = stamp - it.beside > 2.0 * options.settle;
    if (it.shown.motion == TrackMotion::still && is_alone) it.shown.kind = TrackKind::thing;  // somebody passed a post
    return;
  }
  it.ever_moved = true;
  if (it.shown.width <= widest_leg)
    it.shown.kind = TrackKind::leg;
  else
    it.shown.kind = it.shown.width <= widest_person ? TrackKind::person : TrackKind::thing;
}

/// A track for each detection that is of none.
void ObstacleTracker::State::begin() noexcept {
  for (std::size_t d = 0; d < detections.size(); ++d) {
    if (taken[d] != 0 || followed.size() == followed.capacity()) continue;
    const Detection& seen = detections[d];
    Followed it;
    it.shown.id = next_id++;
    it.shown.born = it.shown.last_seen = stamp;
    it.shown.scans = 1;
    it.shown.width = seen.width;
    it.shown.obstacles = {seen.obstacle, -1};
    if (options.confirmations == 1) it.shown.state = TrackState::confirmed;
    it.motion.position = seen.middle;
    it.motion.of_position = seen.noise;
    it.motion.of_velocity = round_noise(first_speed);
    it.leg_share = seen.is_leg ? 0.6 : 0.4;
    it.footprint = seen.footprint;
    it.width = seen.width;
    it.is_part = seen.is_part;
    it.next_test = stamp + seconds_between_tests;
    followed.push_back(it);
  }
}

void ObstacleTracker::State::test(const LaserView& now, const ViewErrors& errors) noexcept {
  for (Followed& it : followed) {
    if (stamp < it.next_test || !it.seen_at(stamp) || it.is_part) continue;
    it.next_test = stamp + seconds_between_tests;
    test_motion(it, views, now, stamp, errors, options);
    name(it);
  }
}

void ObstacleTracker::State::keep_view(const LaserView& now) noexcept {
  const int slot = views.keep(now, stamp);
  if (slot < 0) return;
  for (Followed& it : followed) {
    Followed::Before& before = it.before[static_cast<std::size_t>(slot)];
    before.serial = it.seen_at(stamp) && !it.is_part ? views.serial(slot) : 0;
    before.middle = it.motion.position;
    before.width = it.width;
    before.footprint = it.footprint;
  }
}

bool ObstacleTracker::State::is_over(const Followed& it) const noexcept {
  const double unseen = stamp - it.shown.last_seen;
  if (it.shown.state == TrackState::tentative)
    return stamp - it.shown.born > options.confirm_within || (it.missed >= 2 && 2 * it.missed > it.shown.scans);
  return unseen > it.patience;
}

void ObstacleTracker::State::show() noexcept {
  shown.clear();
  for (Followed& it : followed) {
    it.shown.position = it.motion.position;
    it.shown.velocity = it.moves() ? it.motion.velocity : Vector<2>::Zero();
    it.shown.covariance << it.motion.of_position, it.motion.of_both, it.motion.of_both.transpose(),
        it.motion.of_velocity;
    shown.push_back(it.shown);
  }
}

ObstacleTracker::ObstacleTracker(const ObstacleTrackerOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ObstacleTrackerOptions");
  state_ = std::make_unique<State>(options);
}

ObstacleTracker::~ObstacleTracker() = default;
ObstacleTracker::ObstacleTracker(ObstacleTracker&&) noexcept = default;
ObstacleTracker& ObstacleTracker::operator=(ObstacleTracker&&) noexcept = default;

std::span<const Track> ObstacleTracker::update(const Fix& fix, const LaserScan& scan,
                                               std::span<const Obstacle> obstacles) noexcept {
  State& state = *state_;
  const double seconds = fix.stamp - state.stamp;
  if (state.started && !(seconds > 0.0)) return state.shown;
  const double turn_rate = state.started ? wrap_angle(fix.pose.theta - state.last_pose.theta) / seconds : 0.0;
  if (state.started) state.predict(seconds);
  state.started = true;
  state.stamp = fix.stamp;
  state.last_pose = fix.pose;

  const bool knows_where = fix.usable() && fix.quality.state != TrackingState::lost;
  const LaserView now(scan, fix.pose, turn_rate);
  state.take_detections(fix, scan, knows_where ? obstacles : std::span<const Obstacle>());
  state.assign();
  for (std::size_t k = 0; k < state.followed.size(); ++k) {
    Followed& it = state.followed[k];
    if (state.seen_as[k][0] >= 0)
      state.see(it);
    else
      state.miss(it, now, knows_where);
  }
  std::erase_if(state.followed, [&](const Followed& it) { return state.is_over(it); });
  state.begin();
  if (knows_where) {
    state.test(now, errors_of(fix));
    if (state.stamp >= state.next_pairing) {
      state.next_pairing = state.stamp + seconds_between_tests;
      find_people(state.followed, state.stamp);
    }
    state.keep_view(now);
  }
  state.show();
  return state.shown;
}

std::span<const Track> ObstacleTracker::tracks() const noexcept { return state_->shown; }

void ObstacleTracker::clear() noexcept {
  state_->followed.clear();
  state_->shown.clear();
  state_->views.clear();
  state_->started = false;
}

}  // namespace slamicp
