// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <slamicp/evaluation/error_statistics.hpp>
#include <slamicp/geometry/trajectory.hpp>

namespace slamicp {

struct RelationErrorOptions {
  /// How near a pose's stamp must be to a relation's [s], >= 0. The benchmark's stamps are those of the log, to the
  /// last digit: the tolerance only absorbs the rounding of a trajectory file.
  double stamp_tolerance = 1e-4;
  /// A relation over more than this time [s] says whether the map closed its loops.
  double long_span = 60.0;

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// The errors of a set of relations.
struct RelationErrorStatistics {
  ErrorStatistics translation;   ///< |trans(e)| [m]
  ErrorStatistics rotation_deg;  ///< |rot(e)| [deg], the unit of the published tables
};

/// The score of the SLAM benchmark of Kuemmerle et al. 2009, "On measuring the accuracy of SLAM algorithms": mean and
/// standard deviation over the relations.
struct RelationError {
  RelationErrorStatistics all;
  RelationErrorStatistics long_spans;  ///< of the relations over more than `long_span`
  std::size_t not_found = 0;           ///< relations left out: a stamp of theirs is not in the trajectory

  /// "0.031 +- 0.026 m, 1.30 +- 4.70 deg over 2984 relations; ..."
  std::string brief() const;
};

/// e = inverse(T_a_b) * (inverse(X_a) * X_b) for each relation, X the estimate at its stamps. Needs no alignment.
/// Stamps need not rise; of poses with the same stamp the first in the log counts. O((N + relations) log N).
/// Throws Error for an empty trajectory, no relations, values that are not finite, and no relation whose stamps are
/// found.
RelationError relation_error(const Trajectory& estimate, std::span<const Relation> relations,
                             const RelationErrorOptions& options = {});

}  // namespace slamicp
