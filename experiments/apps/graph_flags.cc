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
              "What an edge between successive nodes measures: the scan_odometry (if there is one, "
              "see --odometry), or the step of the best particle.");
DEFINE_string(edge_information, "proposal",
              "How sure it is of that: proposal (inverse of the covariance of eq. 12), hessian (of "
              "scan matching), constant.");

DEFINE_bool(loop_closure, kSlam.close_loops, "Look for loop closures.");
DEFINE_double(closure_min_way_m, kCloser.candidates.min_way_m,
              "Nodes nearer than this along the graph are no candidates for a closure.");
DEFINE_double(closure_max_distance_m, kCloser.candidates.max_distance_m,
              "Nor are nodes farther apart than this and three times the drift.");
DEFINE_double(closure_drift_m_per_m, kCloser.drift.m_per_m,
              "Drift expected, a standard deviation, per metre of way.");
DEFINE_double(closure_drift_rad_per_m, kCloser.drift.rad_per_m, "Likewise of the heading.");
DEFINE_bool(closure_everywhere, kCloser.search_everywhere,
            "Look for closures in the whole map by the look of places, however large the drift.");
DEFINE_double(closure_min_score, kCloser.verifier.search.min_score,
              "Correlative score (0 to 1) that a closure needs.");
DEFINE_double(closure_max_second_score, kCloser.verifier.max_second_score,
              "A closure is ambiguous if another pose scores this part of the best.");
DEFINE_double(closure_min_overlap, kCloser.verifier.min_overlap,
              "Part of the end points that must lie in the known part of the old map.");
DEFINE_double(closure_min_fit, kCloser.verifier.min_fit,
              "Part of those that the old map must explain.");
DEFINE_double(closure_information_gain, kCloser.verifier.information_gain,
              "Factor of a closure's information: its points are not independent.");

DEFINE_int32(optimize_every, kSlam.optimize_every,
             "The back end runs each time that this many new poses came in (and after closures).");
DEFINE_string(
    graph_thread, "lockstep",
    "When its result is taken over: lockstep (a fixed number of scans later: repeatable), "
    "async (when it is there), inline (with the next scan).");
DEFINE_int32(lockstep_scans, kSlam.graph_thread.lockstep_scans, "That number of scans.");
DEFINE_double(graph_timeout_s, kSlam.graph_thread.timeout_s,
              "A back end that is due is waited for no longer than this (at the end: ten times).");
DEFINE_string(correction, "trajectory",
              "What is corrected of the particles (eq. 14): pose (the current one, as the paper "
              "writes it), trajectory (the whole history, and the maps).");

DEFINE_bool(final_round, kSlam.make_final_round,
            "After the last scan: closures everywhere, optimization, the map from all scans.");
DEFINE_int32(refine, kSlam.final_round.refine,
             "Rounds of aligning all scans with the map in the final round, alternated with the "
             "back end.");

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
