#include "experiments/apps/graph_flags.h"

#include <gflags/gflags.h>

#include "experiments/apps/flag_checks.h"

namespace {
using gmapping_spa::frontend::GraphThread;
using gmapping_spa::frontend::ImprovedGmapping;
using gmapping_spa::particle_filter::EdgeModel;
const ImprovedGmapping::Options kSlam;
const auto& kCloser = kSlam.loop_closer;
}  // namespace

DEFINE_string(edge_measurement, "scan_odometry",
              "What an edge between successive nodes of the pose graph measures: scan_odometry "
              "(the motion that matching every scan found; with --odometry=raw or wheel as "
              "particle) or particle (the step of the best particle).");
DEFINE_string(edge_information, "proposal",
              "Information matrix of an edge between successive nodes: proposal (inverse of the "
              "covariance of eq. 12), hessian (of the scan match) or constant.");

DEFINE_bool(loop_closure, kSlam.close_loops,
            "Look for loop closures and add them to the pose graph.");
DEFINE_double(closure_min_way_m, kCloser.candidates.min_way_m,
              "Loop closures: path length in m from one node to the other, the shortest way "
              "through the graph, from which on they may be closed.");
DEFINE_double(closure_max_distance_m, kCloser.candidates.max_distance_m,
              "Loop closures near the estimate: largest distance in m between two nodes, to which "
              "three standard deviations of the drift between them are added.");
DEFINE_double(
    closure_drift_m_per_m, kCloser.drift.m_per_m,
    "Loop closures: standard deviation of the drift of the position expected, in m per m driven.");
DEFINE_double(
    closure_drift_rad_per_m, kCloser.drift.rad_per_m,
    "Loop closures: standard deviation of the drift of the heading expected, in rad per m driven.");
DEFINE_bool(closure_everywhere, kCloser.search_everywhere,
            "Loop closures: look in the whole map for places that look alike as well (place "
            "recognition), however large the drift. Without it, near the estimate only.");
DEFINE_double(closure_min_score, kCloser.verifier.search.min_score,
              "Loop closures: least score, 0 to 1, of correlative scan matching.");
DEFINE_double(closure_max_second_score, kCloser.verifier.max_second_score,
              "Loop closures: a match is ambiguous, and refused, where another pose scores more "
              "than this part, 0 to 1, of the best score.");
DEFINE_double(closure_min_overlap, kCloser.verifier.min_overlap,
              "Loop closures: least part, 0 to 1, of the new end points that must lie in the known "
              "part of the old local map.");
DEFINE_double(closure_min_fit, kCloser.verifier.min_fit,
              "Loop closures: least part, 0 to 1, of the new end points in the known part of the "
              "old local map that must end at its obstacles.");
DEFINE_double(closure_information_gain, kCloser.verifier.information_gain,
              "Loop closures: factor on the information matrix of the scan match, since "
              "neighboring beams share their errors.");

DEFINE_int32(optimize_every, kSlam.optimize_every,
             "The back end optimizes the pose graph each time that this many nodes were added, and "
             "after each loop closure.");
DEFINE_string(graph_thread, "lockstep",
              "When the filter takes over what the back end, in a thread of its own, found: "
              "lockstep (--lockstep_scans after it was started: the same results every time), "
              "async (as soon as it is there) or inline (at the next scan, for which it waits).");
DEFINE_int32(lockstep_scans, kSlam.graph_thread.lockstep_scans,
             "With --graph_thread=lockstep, number of scans from the start of an optimization to "
             "when its result is taken over.");
DEFINE_double(graph_timeout_s, kSlam.graph_thread.timeout_s,
              "Longest time in s to wait for the back end when its result is due; ten times as "
              "long after the last scan. Then the run goes on without it, and says so.");
DEFINE_string(
    correction, "trajectory",
    "What an optimized graph moves of each particle (eq. 14): pose (its current pose, as the paper "
    "writes it) or trajectory (its whole trajectory, and its map is built anew).");

DEFINE_bool(final_round, kSlam.make_final_round,
            "After the last scan, look for loop closures of all nodes, optimize, align all scans "
            "with the map (--refine) and build the map from all scans.");
DEFINE_int32(
    refine, kSlam.final_round.refine,
    "Number of times that the final round aligns all scans with the map and optimizes; 0: never.");

namespace gmapping_spa::apps {
namespace {

void AddClosureOptions(loop_closure::LoopCloser::Options* closer) {
  closer->candidates.min_way_m = InRange("closure_min_way_m", FLAGS_closure_min_way_m, 0.0, 1e6);
  closer->candidates.max_distance_m =
      InRange("closure_max_distance_m", FLAGS_closure_max_distance_m, 0.0, 100.0);
  closer->drift.m_per_m = InRange("closure_drift_m_per_m", FLAGS_closure_drift_m_per_m, 0.0, 1.0);
  closer->drift.rad_per_m =
      InRange("closure_drift_rad_per_m", FLAGS_closure_drift_rad_per_m, 0.0, 1.0);
  closer->search_everywhere = FLAGS_closure_everywhere;
  closer->verifier.search.min_score =
      InRange("closure_min_score", FLAGS_closure_min_score, 0.01, 1.0);
  closer->verifier.max_second_score =
      InRange("closure_max_second_score", FLAGS_closure_max_second_score, 0.0, 1.0);
  closer->verifier.min_overlap =
      InRange("closure_min_overlap", FLAGS_closure_min_overlap, 0.0, 1.0);
  closer->verifier.min_fit = InRange("closure_min_fit", FLAGS_closure_min_fit, 0.0, 1.0);
  closer->verifier.information_gain =
      InRange("closure_information_gain", FLAGS_closure_information_gain, 1e-6, 1e6);
}

}  // namespace

void AddGraphOptions(ImprovedGmapping::Options* options) {
  EdgeModel::Options& edges = options->filter.edges;
  edges.measurement =
      OneOf<EdgeModel::Measurement>("edge_measurement", FLAGS_edge_measurement,
                                    {{"scan_odometry", EdgeModel::Measurement::kControl},
                                     {"particle", EdgeModel::Measurement::kParticle}});
  if (options->control.source == frontend::OdometrySource::kRaw ||
      options->control.source == frontend::OdometrySource::kWheel) {
    edges.measurement = EdgeModel::Measurement::kParticle;
  }
  edges.information =
      OneOf<EdgeModel::Information>("edge_information", FLAGS_edge_information,
                                    {{"proposal", EdgeModel::Information::kProposal},
                                     {"hessian", EdgeModel::Information::kHessian},
                                     {"constant", EdgeModel::Information::kConstant}});

  options->close_loops = FLAGS_loop_closure;
  AddClosureOptions(&options->loop_closer);

  options->optimize_every = InRange("optimize_every", FLAGS_optimize_every, 1, 1000000);
  options->graph_thread = {
      .mode = OneOf<GraphThread::Mode>("graph_thread", FLAGS_graph_thread,
                                       {{"lockstep", GraphThread::Mode::kLockstep},
                                        {"async", GraphThread::Mode::kAsync},
                                        {"inline", GraphThread::Mode::kInline}}),
      .lockstep_scans = InRange("lockstep_scans", FLAGS_lockstep_scans, 1, 1000000),
      .timeout_s = InRange("graph_timeout_s", FLAGS_graph_timeout_s, 0.0, 1e6)};
  options->correction = OneOf<ImprovedGmapping::Correction>(
      "correction", FLAGS_correction,
      {{"pose", ImprovedGmapping::Correction::kPose},
       {"trajectory", ImprovedGmapping::Correction::kTrajectory}});
  options->make_final_round = FLAGS_final_round;
  options->final_round.refine = InRange("refine", FLAGS_refine, 0, 1000);
}

}  // namespace gmapping_spa::apps
