// SPDX-License-Identifier: BSD-3-Clause
// Errors of a trajectory against the true one, with the conventions of evo
// (github.com/MichaelGrupp/evo), in the plane.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_TRAJECTORY_ERROR_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_TRAJECTORY_ERROR_H_

#include <vector>

#include "backend/se2.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/statistics.h"

namespace gmapping_spa::metrics {

enum class Alignment {
  kNone,   // the two world frames are the same
  kFirst,  // the first poses are laid over each other
  // The rigid motion of least squared distance between the positions (Umeyama, no scale); where
  // these leave the rotation open (one of the two stands still), the one that fits the headings
  // best.
  kSe2,
};

// The unit of the step between the two poses of a pair.
enum class StepUnit {
  kFrames,  // associated poses
  kMetres,  // path length of the estimate
  kSeconds,
};

struct PoseErrorSummary {
  int pairs = 0;
  Statistics translation_m;
  Statistics rotation_deg;
};

// The motion truth_T_estimate between the world frames. Throws std::runtime_error when there is no
// pair of poses.
backend::SE2 Align(const std::vector<PosePair>& pairs, Alignment alignment);

// Absolute trajectory error: per pair of poses the distance of the positions and the angle between
// the headings, once the estimate is aligned. Throws what Align throws.
PoseErrorSummary AbsoluteTrajectoryError(const std::vector<PosePair>& pairs, Alignment alignment);

struct RelativePoseErrorOptions {
  double step = 1.0;  // positive; a whole number for kFrames
  StepUnit unit = StepUnit::kFrames;
};

// Relative pose error: over steps i -> j that follow each other without overlap, translation and
// rotation of (true i_T_j)^-1 * estimated i_T_j. For frames and seconds the first step starts at
// the first pose; for metres, as in evo, where the first step would have ended. A step ends with
// the first pose that is at least that far along. Throws std::invalid_argument when the step is not
// as said above, std::runtime_error when no step fits into the trajectory.
PoseErrorSummary RelativePoseError(const std::vector<PosePair>& pairs,
                                   const RelativePoseErrorOptions& options);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_TRAJECTORY_ERROR_H_
