// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/graph_flags.h"

#include <gflags/gflags.h>

#include "experiments/apps/flag_checks.h"
#include "experiments/apps/slam_option_names.h"

namespace {

using gmapping_spa::SlamOptions;
using gmapping_spa::apps::kCorrectionNames;
using gmapping_spa::apps::kEdgeInformationNames;
using gmapping_spa::apps::kEdgeMeasurementNames;
using gmapping_spa::apps::kGraphThreadNames;

const SlamOptions kSlam;

}  // namespace

DEFINE_string(edge_measurement, NameOf(kEdgeMeasurementNames, kSlam.edge_measurement),
              "What an edge between successive nodes of the pose graph measures: lidar_odometry "
              "(the motion found by matching every scan with the last ones; with --odometry=raw or "
              "wheel the same as particle) or particle (the step of the best particle).");
DEFINE_string(edge_information, NameOf(kEdgeInformationNames, kSlam.edge_information),
              "Information matrix of an edge between successive nodes of the pose graph: proposal "
              "(inverse of the covariance of the improved proposal, eq. 12), hessian (of the scan "
              "match) or constant.");

DEFINE_bool(loop_closure, kSlam.loop_closure,
            "Look for loop closures and add them to the pose graph.");
DEFINE_double(closure_min_path_length_m, kSlam.closure_min_path_length_m,
              "Loop closures: least path length in m, from 0, from one node to the other through "
              "the graph, for the two to be joined.");
DEFINE_double(closure_max_distance_m, kSlam.closure_max_distance_m,
              "Loop closures near the estimate: largest distance between two nodes in m, from 0 to "
              "100, to which three standard deviations of the drift between them are added.");
DEFINE_double(closure_drift_m_per_m, kSlam.closure_drift_m_per_m,
              "Loop closures: expected drift of the position, as a standard deviation in m per m "
              "driven, from 0 to 1.");
DEFINE_double(closure_drift_rad_per_m, kSlam.closure_drift_rad_per_m,
              "Loop closures: expected drift of the heading, as a standard deviation in rad per m "
              "driven, from 0 to 1.");
DEFINE_bool(closure_everywhere, kSlam.closure_everywhere,
            "Loop closures: recognize places in the whole map, however large the drift. Without "
            "it, loop closures are found near the estimate only.");
DEFINE_double(closure_min_score, kSlam.closure_min_score,
              "Loop closures: least score of the correlative scan match, from 0.01 to 1, for a "
              "candidate to be accepted.");
DEFINE_double(closure_max_runner_up_score, kSlam.closure_max_runner_up_score,
              "Loop closures: a candidate is ambiguous, and rejected, where another pose scores "
              "more than this part, 0 to 1, of the best score.");
DEFINE_double(closure_min_overlap, kSlam.closure_min_overlap,
              "Loop closures: least part, 0 to 1, of the new scan's end points that must lie in "
              "the known part of the old local map for a candidate to be accepted.");
DEFINE_double(
    closure_min_inlier_ratio, kSlam.closure_min_inlier_ratio,
    "Loop closures: inlier ratio, 0 to 1: least part of the new scan's end points in the known "
    "part of the old local map that must lie at its obstacles for a candidate to be accepted. Less "
    "is needed, in proportion and down to 0.7 times this value, where scans taken next to each "
    "other explain less than 0.86 of each other, as among people or with few beams.");
DEFINE_double(closure_information_gain, kSlam.closure_information_gain,
              "Loop closures: factor, above 0, on the information matrix of the scan match; below "
              "1, since neighboring beams share their errors.");

DEFINE_int32(optimize_every, kSlam.optimize_every,
             "Number of nodes, from 1, that are added to the pose graph between two optimizations "
             "by the back end; it optimizes after each loop closure as well.");
DEFINE_string(
    graph_thread, NameOf(kGraphThreadNames, kSlam.graph_thread),
    "When the filter applies the graph that the back end optimizes in a thread of its own: "
    "lockstep (--lockstep_scans scans after the start: the same results every time), async (as "
    "soon as it is there) or inline (at the next scan, which waits for it).");
DEFINE_int32(lockstep_scans, kSlam.lockstep_scans,
             "With --graph_thread=lockstep, number of scans, from 1, from the start of an "
             "optimization to the scan at which its result is applied.");
DEFINE_double(
    graph_timeout_s, kSlam.graph_timeout_s,
    "Longest time in s, from 0, to wait for the back end when its result is due, ten times as long "
    "after the last scan. Then the run goes on without the result, and says so.");
DEFINE_string(
    correction, NameOf(kCorrectionNames, kSlam.correction),
    "What an optimized graph moves of each particle (eq. 14): pose (its current pose, as the paper "
    "writes it) or trajectory (its whole trajectory, and its map is built anew).");

DEFINE_bool(final_optimization, kSlam.final_optimization,
            "After the last scan, look for loop closures of all nodes, optimize, align all scans "
            "with the map (--refine) and build the map from all scans.");
DEFINE_int32(refine, kSlam.refine,
             "Number of times, from 0, that the final optimization aligns all scans with the map "
             "and optimizes the pose graph.");

namespace gmapping_spa::apps {

FlagGroups GraphFlagGroups() {
  return {{"graph",
           "Pose graph",
           {"edge_measurement", "edge_information", "optimize_every", "graph_thread",
            "lockstep_scans", "graph_timeout_s", "correction", "final_optimization", "refine"}},
          {"loop_closures",
           "Loop closures",
           {"loop_closure", "closure_everywhere", "closure_min_path_length_m",
            "closure_max_distance_m", "closure_drift_m_per_m", "closure_drift_rad_per_m",
            "closure_min_score", "closure_max_runner_up_score", "closure_min_overlap",
            "closure_min_inlier_ratio", "closure_information_gain"}}};
}

void AddGraphOptions(SlamOptions* options) {
  options->edge_measurement =
      OneOf("edge_measurement", FLAGS_edge_measurement, kEdgeMeasurementNames);
  options->edge_information =
      OneOf("edge_information", FLAGS_edge_information, kEdgeInformationNames);

  options->loop_closure = FLAGS_loop_closure;
  options->closure_min_path_length_m = FLAGS_closure_min_path_length_m;
  options->closure_max_distance_m = FLAGS_closure_max_distance_m;
  options->closure_drift_m_per_m = FLAGS_closure_drift_m_per_m;
  options->closure_drift_rad_per_m = FLAGS_closure_drift_rad_per_m;
  options->closure_everywhere = FLAGS_closure_everywhere;
  options->closure_min_score = FLAGS_closure_min_score;
  options->closure_max_runner_up_score = FLAGS_closure_max_runner_up_score;
  options->closure_min_overlap = FLAGS_closure_min_overlap;
  options->closure_min_inlier_ratio = FLAGS_closure_min_inlier_ratio;
  options->closure_information_gain = FLAGS_closure_information_gain;

  options->optimize_every = FLAGS_optimize_every;
  options->graph_thread = OneOf("graph_thread", FLAGS_graph_thread, kGraphThreadNames);
  options->lockstep_scans = FLAGS_lockstep_scans;
  options->graph_timeout_s = FLAGS_graph_timeout_s;
  options->correction = OneOf("correction", FLAGS_correction, kCorrectionNames);
  options->final_optimization = FLAGS_final_optimization;
  options->refine = FLAGS_refine;
}

}  // namespace gmapping_spa::apps
