// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include <slamicp/obstacles/oriented_box.hpp>

namespace slamicp {

/// What a track is of, by its size and how it moves.
enum class TrackKind {
  thing,   ///< anything else; who has stood since they came into view, too: a leg and a post look the same
  leg,     ///< 25 cm wide at most, and it has moved, or stands beside a leg that moves
  person,  ///< two legs that moved together, or one thing of 25 to 80 cm that moved; it stays that when it stands
};

/// Whether it moves.
enum class TrackMotion {
  undecided,  ///< too new to tell
  still,      ///< it has stayed where it is
  moving,     ///< it is where the laser saw free space, or free space is where it was
};

/// How well it is known.
enum class TrackState {
  tentative,  ///< seen in too few scans to be believed
  confirmed,  ///< seen in this scan
  hidden,     ///< not seen in this scan; something nearer stands before it, or it is about to be given up
};

/// "thing", "leg", "person"
const char* to_string(TrackKind kind) noexcept;
/// "undecided", "static", "moving"
const char* to_string(TrackMotion motion) noexcept;
/// "tentative", "confirmed", "hidden"
const char* to_string(TrackState state) noexcept;

/// Something that stands or moves where the map has nothing, followed from scan to scan.
struct Track {
  int id = 0;  ///< counts from 1; never used again
  TrackKind kind = TrackKind::thing;
  TrackMotion motion = TrackMotion::undecided;
  TrackState state = TrackState::tentative;
  Point2 position = Point2::Zero();                ///< its middle, in the map [m]; of a person between the legs
  Vector<2> velocity = Vector<2>::Zero();          ///< in the map [m/s]; zero while it is not known to move
  Matrix<4, 4> covariance = Matrix<4, 4>::Zero();  ///< of position and velocity, the pose's uncertainty included
  double width = 0.0;                              ///< the longer side of what was seen of it, averaged [m]
  double born = 0.0;                               ///< stamp of the scan that showed it first [s]
  double last_seen = 0.0;                          ///< stamp of the last scan that showed it [s]
  int scans = 0;                                   ///< that showed it
  /// Which of the obstacles given to this update it was seen as; -1: none. The second one is somebody's other leg.
  std::array<int, 2> obstacles = {-1, -1};

  double speed() const noexcept { return velocity.norm(); }  ///< [m/s]
  /// "7 person, moving, confirmed, at 3.10 m, 0.55 m, 1.18 m/s"
  std::string brief() const;
};

/// In one word, as obstacles CSV has it: "tentative", "person", "leg", "moving", "static", "undecided"; the first that
/// holds.
const char* word_of(const Track& track) noexcept;

}  // namespace slamicp
