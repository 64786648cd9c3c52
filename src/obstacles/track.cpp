// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <slamicp/obstacles/track.hpp>

namespace slamicp {

const char* to_string(TrackKind kind) noexcept {
  switch (kind) {
    case TrackKind::thing:
      return "thing";
    case TrackKind::leg:
      return "leg";
    case TrackKind::person:
      return "person";
  }
  return "unknown";
}

const char* to_string(TrackMotion motion) noexcept {
  switch (motion) {
    case TrackMotion::undecided:
      return "undecided";
    case TrackMotion::still:
      return "static";
    case TrackMotion::moving:
      return "moving";
  }
  return "unknown";
}

const char* to_string(TrackState state) noexcept {
  switch (state) {
    case TrackState::tentative:
      return "tentative";
    case TrackState::confirmed:
      return "confirmed";
    case TrackState::hidden:
      return "hidden";
  }
  return "unknown";
}

const char* word_of(const Track& track) noexcept {
  if (track.state == TrackState::tentative) return to_string(track.state);
  if (track.kind != TrackKind::thing) return to_string(track.kind);
  return to_string(track.motion);
}

std::string Track::brief() const {
  char text[160];
  std::snprintf(text, sizeof text, "%d %s, %s, %s, at %.2f m, %.2f m, %.2f m/s", id, to_string(kind), to_string(motion),
                to_string(state), position.x(), position.y(), speed());
  return text;
}

}  // namespace slamicp
