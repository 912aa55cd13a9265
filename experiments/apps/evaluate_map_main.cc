// SPDX-License-Identifier: BSD-3-Clause
// Compares a map with the true one, as far as the robot could have seen it, and prints the errors
// as JSON.
#include <gflags/gflags.h>

#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/out_of_memory.h"
#include "experiments/apps/app.h"
#include "experiments/apps/error_picture.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/apps/json.h"
#include "experiments/apps/staging_folder.h"
#include "experiments/apps/trajectory_files.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/best_alignment.h"
#include "experiments/metrics/corner_errors.h"
#include "experiments/metrics/ghost_walls.h"
#include "experiments/metrics/map_comparison.h"
#include "experiments/metrics/map_error.h"
#include "experiments/metrics/map_structure.h"
#include "experiments/metrics/object_errors.h"
#include "experiments/metrics/seen_space.h"
#include "experiments/metrics/trajectory_error.h"
#include "experiments/metrics/wall_errors.h"
#include "frontend/map/map_server_io.h"

DEFINE_string(map, "", "YAML file of the map to score (map_server).");
DEFINE_string(
    truth, "",
    "YAML file of the true map (map_server). Empty: only what needs no truth is measured.");
DEFINE_string(truth_trajectory, "",
              "File of the true trajectory (TUM): the poses from which the robot looked.");
DEFINE_string(
    trajectory, "",
    "File of the trajectory that belongs to the map (TUM). Not needed with --align=none.");
DEFINE_string(
    align, "se2",
    "How the map is laid over the truth, by the trajectories: se2 (least squared distance of the "
    "positions, no scale), first (by the first poses) or none.");
DEFINE_double(
    max_gap_s, 0.01,
    "Largest difference in s, from 0, between the stamps of two poses that belong together.");
DEFINE_double(max_range, 30.0,
              "Range of the laser in m, from 0.01 to 10000: surface farther from all true poses is "
              "out of sight.");
DEFINE_double(tolerance, 0.1,
              "Distance in m, from 0: surface is missing when no occupied cell is this near, an "
              "occupied cell is extra when no surface is.");
DEFINE_string(objects, "",
              "YAML file of a map in the grid of --truth, occupied where the things stand that are "
              "scored by themselves, such as truth_obstacles.yaml of simulate. Empty: none.");
DEFINE_string(error_map, "", "PNG file that gets a picture of the errors of the map. Empty: none.");

namespace gmapping_spa::apps {
namespace {

Json ToJson(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json ToJson(const std::optional<metrics::MeanAndP95>& errors) {
  if (!errors) return {{"mean", nullptr}, {"p95", nullptr}};
  return {{"mean", errors->mean}, {"p95", errors->p95}};
}

void CheckFlags() {
  if (FLAGS_map.empty()) throw std::runtime_error("--map=FILE is missing");
  if (!(FLAGS_max_gap_s >= 0.0)) throw std::runtime_error("--max_gap_s must not be negative");
  InRange("max_range", FLAGS_max_range, 0.01, 1e4);
  InRange("tolerance", FLAGS_tolerance, 0.0, metrics::kDistanceCap_m);
  if (FLAGS_truth.empty()) {
    for (const auto& [name, value] :
         {std::pair("truth_trajectory", FLAGS_truth_trajectory),
          std::pair("trajectory", FLAGS_trajectory), std::pair("objects", FLAGS_objects),
          std::pair("error_map", FLAGS_error_map)}) {
      if (value.empty()) continue;
      throw std::runtime_error("--" + std::string(name) + " needs --truth=FILE");
    }
  } else if (FLAGS_truth_trajectory.empty()) {
    throw std::runtime_error("--truth needs --truth_trajectory=FILE");
  }
}

map::TrinaryMap ReadMapFile(const std::string& path) {
  CompleteSetOf(path);
  return backend::WithMemory("while reading " + path, [&] { return map::ReadMap(path); });
}

// How the map lies over the truth: by all poses together, as --align says, and by single ones.
struct Alignments {
  backend::SE2 truth_T_map;
  std::vector<backend::SE2> by_pose;  // evenly over the trajectory; none with --align=none
};

Alignments AlignmentsFromFlags(const TrajectoryFile& truth) {
  const metrics::Alignment alignment = OneOf("align", FLAGS_align, kAlignments);
  if (alignment == metrics::Alignment::kNone) return {};
  if (FLAGS_trajectory.empty()) {
    throw std::runtime_error("--align=" + FLAGS_align + " needs --trajectory=FILE");
  }
  const std::vector<metrics::PosePair> pairs =
      AssociateFiles(truth, ReadTrajectoryFile(FLAGS_trajectory), FLAGS_max_gap_s);
  Alignments alignments{metrics::Align(pairs, alignment), {}};
  constexpr std::size_t kPoses = 20;
  for (std::size_t i = 0; i < kPoses; ++i) {
    const metrics::PosePair& pair = pairs[i * (pairs.size() - 1) / (kPoses - 1)];
    alignments.by_pose.push_back(pair.truth_T_robot * Inverse(pair.estimate_T_robot));
  }
  return alignments;
}

// The map where most of it fits, which may be another place than the trajectory says.
metrics::MapComparison CompareWhereItFits(const map::TrinaryMap& truth,
                                          const metrics::MapComparison& comparison,
                                          const map::TrinaryMap& map, const Alignments& alignments,
                                          backend::SE2* truth_T_map) {
  *truth_T_map = alignments.truth_T_map;
  if (alignments.by_pose.empty()) return comparison;
  std::vector<backend::SE2> candidates = {alignments.truth_T_map};
  candidates.insert(candidates.end(), alignments.by_pose.begin(), alignments.by_pose.end());
  *truth_T_map = metrics::FindBestAlignment(truth, map, candidates);
  return metrics::CompareMaps(truth, comparison.seen, map, *truth_T_map);
}

Json ToJson(const backend::SE2& truth_T_map) {
  return {{"x_m", truth_T_map.x}, {"y_m", truth_T_map.y}, {"theta_rad", truth_T_map.theta}};
}

Json ToJson(const metrics::WallErrors& errors) {
  return {{"in_sight", errors.walls},
          {"in_sight_m", errors.walls_m},
          {"missing", errors.missing_walls},
          {"broken", errors.broken_walls},
          {"gaps", errors.gaps},
          {"gaps_m", errors.gaps_m},
          {"doubled", errors.doubled_walls},
          {"doubled_m", errors.doubled_walls_m}};
}

Json ToJson(const std::vector<metrics::GhostWall>& walls) {
  double length_m = 0.0;
  for (const metrics::GhostWall& wall : walls) length_m += wall.length_m;
  return {{"number", walls.size()}, {"length_m", length_m}};
}

Json ToJson(const metrics::CornerErrors& errors) {
  return {{"in_sight", errors.in_sight.size()},
          {"found", errors.found},
          {"false", errors.false_ones.size()}};
}

Json ToJson(const std::vector<metrics::ObjectErrors>& objects) {
  Json json = Json::array();
  for (const metrics::ObjectErrors& object : objects) {
    json.push_back({{"x_m", object.center.x()},
                    {"y_m", object.center.y()},
                    {"surface_m", object.surface_m},
                    {"there", object.is_there()},
                    {"complete", ToJson(object.complete)},
                    {"width_m", ToJson(object.width_m)}});
  }
  return json;
}

Json AgainstTruth(const map::TrinaryMap& map) {
  const map::TrinaryMap truth = ReadMapFile(FLAGS_truth);
  const TrajectoryFile true_trajectory = ReadTrajectoryFile(FLAGS_truth_trajectory);
  const backend::Trajectory& true_poses = true_trajectory.poses;
  const Alignments alignments = AlignmentsFromFlags(true_trajectory);
  const backend::SE2& truth_T_map = alignments.truth_T_map;
  const auto seen = metrics::LookAround(truth, true_poses, FLAGS_max_range);
  const auto comparison = metrics::CompareMaps(truth, seen, map, truth_T_map);
  const auto errors = metrics::SummarizeErrors(comparison, FLAGS_tolerance);
  backend::SE2 best_truth_T_map;
  const auto fitted = CompareWhereItFits(truth, comparison, map, alignments, &best_truth_T_map);
  const auto ghosts = metrics::FindGhostWalls(fitted, FLAGS_tolerance);
  if (!FLAGS_error_map.empty()) {
    WriteErrorPicture(truth, comparison, FLAGS_tolerance, FLAGS_error_map);
  }
  Json json = {
      {"truth", {{"resolution_m", truth.resolution_m}, {"true_poses", true_poses.size()}}},
      {"align", FLAGS_align},
      {"alignment", ToJson(truth_T_map)},
      {"seen",
       {{"max_range_m", FLAGS_max_range},
        {"view_points", seen.view_points},
        {"free_cells", comparison.seen_cells},
        {"surface_elements", errors.surface_elements},
        {"straight_elements", errors.straight_elements}}},
      {"tolerance_m", FLAGS_tolerance},
      {"map_to_truth_m", ToJson(errors.map_to_truth_m)},
      {"truth_to_map_m", ToJson(errors.truth_to_map_m)},
      {"precision", ToJson(errors.precision)},
      {"recall", ToJson(errors.recall)},
      {"iou", ToJson(errors.iou)},
      {"known", ToJson(errors.known)},
      {"matched_elements", errors.matched_elements},
      {"blur_m", ToJson(errors.blur_m)},
      {"shift_m", ToJson(errors.shift_m)},
      {"missing", ToJson(errors.missing)},
      {"extra", ToJson(errors.extra)},
      {"outside", ToJson(errors.outside)},
      {"broken", errors.broken ? Json(*errors.broken) : Json(nullptr)},
      {"best_alignment", ToJson(best_truth_T_map)},
      {"walls", ToJson(metrics::FindWallErrors(fitted, ghosts, FLAGS_tolerance))},
      {"ghost_walls", ToJson(ghosts)},
      {"corners", ToJson(metrics::FindCornerErrors(truth, fitted, FLAGS_tolerance))},
      {"convention",
       "true surface: edges between occupied and seen free cells of the truth; a cell that the "
       "surface passes through is 0 m off; distances up to 1 m; precision, recall, iou within one "
       "cell; blur and shift along the normals of straight surface; null: nothing to measure"}};
  if (!FLAGS_objects.empty()) {
    json["objects"] = ToJson(
        metrics::FindObjectErrors(truth, ReadMapFile(FLAGS_objects), fitted, FLAGS_tolerance));
  }
  return json;
}

void Compare(const map::TrinaryMap& map) {
  const metrics::MapStructure structure = metrics::MeasureStructure(map);
  Json json = {{"map",
                {{"resolution_m", map.resolution_m},
                 {"occupied_cells", structure.occupied_cells},
                 {"enclosed_areas", structure.enclosed_areas},
                 {"corners", structure.corners}}}};
  if (!FLAGS_truth.empty()) json.update(AgainstTruth(map));
  std::cout << TextOf(json) << '\n';
}

void Run() {
  CheckFlags();
  const map::TrinaryMap map = ReadMapFile(FLAGS_map);
  backend::WithMemory("while measuring a map of " + std::to_string(map.width) + " x " +
                          std::to_string(map.height) + " cells",
                      [&] { Compare(map); });
}

FlagGroups AllFlagGroups() {
  return {{"files",
           "Files",
           {"map", "truth", "trajectory", "truth_trajectory", "objects", "error_map"}},
          {"comparison", "Comparison", {"align", "max_gap_s", "max_range", "tolerance"}}};
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "compares a map with the true one, as far as the robot could have seen it, and prints the "
      "errors as JSON.\nUsage: evaluate_map --map=FILE [--truth=FILE --truth_trajectory=FILE "
      "--trajectory=FILE]\nTrajectories may be gzipped.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
