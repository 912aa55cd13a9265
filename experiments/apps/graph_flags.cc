#include "experiments/apps/graph_flags.h"

#include <gflags/gflags.h>

#include "experiments/apps/flag_checks.h"

namespace {

using gmapping_spa::SlamOptions;
using gmapping_spa::apps::Choices;
using gmapping_spa::apps::NameOf;

const SlamOptions kSlam;
const Choices<SlamOptions::EdgeMeasurement> kEdgeMeasurement = {
    {"lidar_odometry", SlamOptions::EdgeMeasurement::kLidarOdometry},
    {"particle", SlamOptions::EdgeMeasurement::kParticle}};
const Choices<SlamOptions::EdgeInformation> kEdgeInformation = {
    {"proposal", SlamOptions::EdgeInformation::kProposal},
    {"hessian", SlamOptions::EdgeInformation::kHessian},
    {"constant", SlamOptions::EdgeInformation::kConstant}};
const Choices<SlamOptions::GraphThread> kGraphThread = {
    {"lockstep", SlamOptions::GraphThread::kLockstep},
    {"async", SlamOptions::GraphThread::kAsync},
    {"inline", SlamOptions::GraphThread::kInline}};
const Choices<SlamOptions::Correction> kCorrection = {
    {"pose", SlamOptions::Correction::kPose}, {"trajectory", SlamOptions::Correction::kTrajectory}};

}  // namespace

DEFINE_string(edge_measurement, NameOf(kEdgeMeasurement, kSlam.edge_measurement),
              "What an edge between successive nodes of the pose graph measures: lidar_odometry "
              "(the motion that matching every scan found; with --odometry=raw or wheel as "
              "particle) or particle (the step of the best particle).");
DEFINE_string(edge_information, NameOf(kEdgeInformation, kSlam.edge_information),
              "Information matrix of an edge between successive nodes: proposal (inverse of the "
              "covariance of eq. 12), hessian (of the scan match) or constant.");

DEFINE_bool(loop_closure, kSlam.loop_closure,
            "Look for loop closures and add them to the pose graph.");
DEFINE_double(closure_min_path_length_m, kSlam.closure_min_path_length_m,
              "Loop closures: path length in m from one node to the other, the shortest way "
              "through the graph, from which on they may be closed.");
DEFINE_double(closure_max_distance_m, kSlam.closure_max_distance_m,
              "Loop closures near the estimate: largest distance in m between two nodes, to which "
              "three standard deviations of the drift between them are added.");
DEFINE_double(
    closure_drift_m_per_m, kSlam.closure_drift_m_per_m,
    "Loop closures: standard deviation of the drift of the position expected, in m per m driven.");
DEFINE_double(
    closure_drift_rad_per_m, kSlam.closure_drift_rad_per_m,
    "Loop closures: standard deviation of the drift of the heading expected, in rad per m driven.");
DEFINE_bool(closure_everywhere, kSlam.closure_everywhere,
            "Loop closures: look in the whole map for places that look alike as well (place "
            "recognition), however large the drift. Without it, near the estimate only.");
DEFINE_double(closure_min_score, kSlam.closure_min_score,
              "Loop closures: least score, 0 to 1, of correlative scan matching.");
DEFINE_double(closure_max_runner_up_score, kSlam.closure_max_runner_up_score,
              "Loop closures: a match is ambiguous, and refused, where another pose scores more "
              "than this part, 0 to 1, of the best score.");
DEFINE_double(closure_min_overlap, kSlam.closure_min_overlap,
              "Loop closures: least part, 0 to 1, of the new end points that must lie in the known "
              "part of the old local map.");
DEFINE_double(closure_min_inlier_ratio, kSlam.closure_min_inlier_ratio,
              "Loop closures: least part, 0 to 1, of the new end points in the known part of the "
              "old local map that must end at its obstacles.");
DEFINE_double(closure_information_gain, kSlam.closure_information_gain,
              "Loop closures: factor on the information matrix of the scan match, since "
              "neighboring beams share their errors.");

DEFINE_int32(optimize_every, kSlam.optimize_every,
             "The back end optimizes the pose graph each time that this many nodes were added, and "
             "after each loop closure.");
DEFINE_string(graph_thread, NameOf(kGraphThread, kSlam.graph_thread),
              "When the filter takes over what the back end, in a thread of its own, found: "
              "lockstep (--lockstep_scans after it was started: the same results every time), "
              "async (as soon as it is there) or inline (at the next scan, for which it waits).");
DEFINE_int32(lockstep_scans, kSlam.lockstep_scans,
             "With --graph_thread=lockstep, number of scans from the start of an optimization to "
             "when its result is taken over.");
DEFINE_double(graph_timeout_s, kSlam.graph_timeout_s,
              "Longest time in s to wait for the back end when its result is due; ten times as "
              "long after the last scan. Then the run goes on without it, and says so.");
DEFINE_string(
    correction, NameOf(kCorrection, kSlam.correction),
    "What an optimized graph moves of each particle (eq. 14): pose (its current pose, as the paper "
    "writes it) or trajectory (its whole trajectory, and its map is built anew).");

DEFINE_bool(final_optimization, kSlam.final_optimization,
            "After the last scan, look for loop closures of all nodes, optimize, align all scans "
            "with the map (--refine) and build the map from all scans.");
DEFINE_int32(refine, kSlam.refine,
             "Number of times that the final optimization aligns all scans with the map and "
             "optimizes; 0: never.");

namespace gmapping_spa::apps {

void AddGraphOptions(SlamOptions* options) {
  options->edge_measurement = OneOf("edge_measurement", FLAGS_edge_measurement, kEdgeMeasurement);
  options->edge_information = OneOf("edge_information", FLAGS_edge_information, kEdgeInformation);

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
  options->graph_thread = OneOf("graph_thread", FLAGS_graph_thread, kGraphThread);
  options->lockstep_scans = FLAGS_lockstep_scans;
  options->graph_timeout_s = FLAGS_graph_timeout_s;
  options->correction = OneOf("correction", FLAGS_correction, kCorrection);
  options->final_optimization = FLAGS_final_optimization;
  options->refine = FLAGS_refine;
}

}  // namespace gmapping_spa::apps
