// SPDX-License-Identifier: BSD-3-Clause
// Scores a trajectory by the relations benchmark and prints the numbers as JSON.
#include <gflags/gflags.h>

#include <iostream>
#include <stdexcept>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/app.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/json.h"
#include "experiments/apps/trajectory_files.h"
#include "experiments/metrics/relations.h"

DEFINE_string(relations, "",
              "File of the true relations, a line t1 t2 x y z roll pitch yaw each (s, m, rad), "
              "plain or gzipped.");
DEFINE_string(trajectory, "", "File of the trajectory to score (TUM).");
DEFINE_double(max_gap_s, gmapping_spa::metrics::RelationsOptions().max_gap_s,
              "Largest distance in s, from 0, of each stamp of a relation to a stamp of the "
              "trajectory for the relation to count; between stamps the pose is interpolated.");

namespace gmapping_spa::apps {
namespace {

void Run() {
  if (FLAGS_relations.empty()) throw std::runtime_error("--relations=FILE is missing");
  if (FLAGS_trajectory.empty()) throw std::runtime_error("--trajectory=FILE is missing");
  if (!(FLAGS_max_gap_s >= 0.0)) throw std::runtime_error("--max_gap_s must not be negative");
  const auto relations = metrics::ReadRelations(*OpenInput(FLAGS_relations), FLAGS_relations);
  if (relations.empty()) throw std::runtime_error(FLAGS_relations + ": holds no relations");
  const backend::Trajectory trajectory = ReadTrajectoryFile(FLAGS_trajectory).poses;
  const metrics::RelationsSummary summary =
      metrics::EvaluateRelations(relations, trajectory, {.max_gap_s = FLAGS_max_gap_s});
  const Json json = {
      {"relations", relations.size()},
      {"used", summary.used},
      {"not_associated", summary.not_associated},
      {"poses", trajectory.size()},
      {"max_gap_s", FLAGS_max_gap_s},
      {"translation_m", ToJson(summary.translation_m)},
      {"rotation_deg", ToJson(summary.rotation_deg)},
      {"convention",
       "Kuemmerle et al. 2009 in the plane: length of the translation and absolute rotation of "
       "inverse(true i_T_j) * estimated i_T_j over the relations used; std is that of the "
       "population"}};
  std::cout << TextOf(json) << '\n';
}

FlagGroups AllFlagGroups() {
  return {{"files", "Files", {"relations", "trajectory"}},
          {"comparison", "Comparison", {"max_gap_s"}}};
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "scores a trajectory by hand-checked relations between poses (Kuemmerle et al. 2009) and "
      "prints JSON.\nUsage: evaluate_relations --relations=FILE --trajectory=FILE\n"
      "Files may be gzipped.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
