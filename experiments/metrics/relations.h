// SPDX-License-Identifier: BSD-3-Clause
// The relations benchmark: Kuemmerle et al., On measuring the accuracy of SLAM algorithms,
// Autonomous Robots 27(4), 2009.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_RELATIONS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_RELATIONS_H_

#include <istream>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "experiments/metrics/statistics.h"

namespace gmapping_spa::metrics {

// True motion of the robot between two moments i and j.
struct Relation {
  double stamp_i_s = 0.0;
  double stamp_j_s = 0.0;
  backend::SE2 i_T_j;
};

// Reads lines "t1 t2 x y z roll pitch yaw", the pose at t2 relative to that at t1 in seconds,
// metres and radians; z, roll and pitch are dropped. Blank lines and '#' comments are skipped.
// Throws std::runtime_error "<name>:<line>: expected <what>, found <what>" on anything else.
std::vector<Relation> ReadRelations(std::istream& in, const std::string& name);

struct RelationsOptions {
  // A relation counts only if each of its two moments has a stamp of the trajectory this near. The
  // pose is interpolated between neighbors when there is no exact stamp: see PoseAt.
  double max_gap_s = 0.1;
};

struct RelationsSummary {
  int used = 0;
  int not_associated = 0;
  // Of (i_T_j)^-1 * estimated i_T_j over the relations used.
  Statistics translation_m;  // length of the translation
  Statistics rotation_deg;   // absolute value of the rotation
};

// The trajectory may be in any order. Throws std::runtime_error when no relation can be used.
RelationsSummary EvaluateRelations(const std::vector<Relation>& relations,
                                   const backend::Trajectory& trajectory,
                                   const RelationsOptions& options);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_RELATIONS_H_
