// SPDX-License-Identifier: BSD-3-Clause
// Compares a trajectory with the true one and prints the errors as JSON.
#include <gflags/gflags.h>

#include <iostream>
#include <stdexcept>
#include <string>

#include "experiments/apps/app.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/apps/json.h"
#include "experiments/apps/trajectory_files.h"
#include "experiments/metrics/trajectory_error.h"

DEFINE_string(truth, "", "File of the true trajectory (TUM or KITTI).");
DEFINE_string(trajectory, "", "File of the trajectory to score, in the format of the true one.");
DEFINE_double(
    max_gap_s, 0.01,
    "Largest difference in s, from 0, between the stamps of two poses that belong together.");
DEFINE_string(
    align, "se2",
    "How the trajectory is laid over the truth before absolute errors are taken: se2 (least "
    "squared distance, no scale), first (by the first poses) or none.");
DEFINE_double(
    rpe_delta, 1.0,
    "Length of a step of the relative pose error (RPE), above 0, in the unit of --rpe_unit.");
DEFINE_string(rpe_unit, "frames",
              "Unit of the step of the relative pose error (RPE), --rpe_delta: frames (poses), m "
              "(path length) or s.");

namespace gmapping_spa::apps {
namespace {

constexpr backend::EnumName<metrics::StepUnit> kStepUnits[] = {
    {"frames", metrics::StepUnit::kFrames},
    {"m", metrics::StepUnit::kMetres},
    {"s", metrics::StepUnit::kSeconds}};

Json ErrorsToJson(const metrics::PoseErrorSummary& summary) {
  return {{"pairs", summary.pairs},
          {"translation_m", ToJson(summary.translation_m)},
          {"rotation_deg", ToJson(summary.rotation_deg)}};
}

void Run() {
  if (FLAGS_truth.empty()) throw std::runtime_error("--truth=FILE is missing");
  if (FLAGS_trajectory.empty()) throw std::runtime_error("--trajectory=FILE is missing");
  if (!(FLAGS_max_gap_s >= 0.0)) throw std::runtime_error("--max_gap_s must not be negative");
  const metrics::Alignment alignment = OneOf("align", FLAGS_align, kAlignments);
  const metrics::StepUnit unit = OneOf("rpe_unit", FLAGS_rpe_unit, kStepUnits);
  const TrajectoryFile truth = ReadTumOrKittiFile(FLAGS_truth);
  const TrajectoryFile trajectory = ReadTumOrKittiFile(FLAGS_trajectory);
  if (!truth.has_stamps && unit == metrics::StepUnit::kSeconds) {
    throw std::runtime_error("--rpe_unit=s: expected files with stamps (TUM), found " +
                             FLAGS_truth + " without (KITTI)");
  }
  const auto pairs = AssociateFiles(truth, trajectory, FLAGS_max_gap_s);
  const backend::SE2 truth_T_estimate = metrics::Align(pairs, alignment);
  const auto absolute = metrics::AbsoluteTrajectoryError(pairs, alignment);
  const auto relative = metrics::RelativePoseError(pairs, {.step = FLAGS_rpe_delta, .unit = unit});
  const Json json = {
      {"truth_poses", truth.poses.size()},
      {"trajectory_poses", trajectory.poses.size()},
      {"associated", pairs.size()},
      {"max_gap_s", truth.has_stamps ? Json(FLAGS_max_gap_s) : Json(nullptr)},
      {"align", FLAGS_align},
      {"alignment",
       {{"x_m", truth_T_estimate.x},
        {"y_m", truth_T_estimate.y},
        {"theta_rad", truth_T_estimate.theta}}},
      {"ate", ErrorsToJson(absolute)},
      {"rpe_delta", FLAGS_rpe_delta},
      {"rpe_unit", FLAGS_rpe_unit},
      {"rpe", ErrorsToJson(relative)},
      {"convention",
       "as evo, in the plane: poses associated by nearest stamp, in files without stamps "
       "(KITTI) by their number; ate: distances and angles between "
       "poses after the alignment (rigid, without scale); rpe: inverse(true i_T_j) * estimated "
       "i_T_j over consecutive steps without overlap; std is that of the population"}};
  std::cout << TextOf(json) << '\n';
}

FlagGroups AllFlagGroups() {
  return {{"files", "Files", {"truth", "trajectory"}},
          {"comparison", "Comparison", {"align", "max_gap_s", "rpe_delta", "rpe_unit"}}};
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "compares a trajectory with the true one and prints absolute (ATE) and relative (RPE) errors "
      "as JSON.\nUsage: evaluate_trajectory --truth=FILE --trajectory=FILE\nFiles are of the TUM "
      "format or "
      "both of KITTI's, and may be gzipped.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
