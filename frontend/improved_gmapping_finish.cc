// SPDX-License-Identifier: BSD-3-Clause
// What comes after the last scan.
#include "frontend/improved_gmapping.h"

namespace gmapping_spa::frontend {

FinalOptimization ImprovedGmapping::MakeFinalOptimization(
    const FinalOptimization::Options& options) {
  return FinalOptimization(
      options,
      {.scans = &archive_,
       .node_scans = &node_scans_,
       .scan_poses = &scan_poses_,
       .grid = options_.filter.grid,
       .insertion = options_.filter.insertion,
       .pieces = &loop_closer_.pieces(),
       .known = session_ && session_->is_fixed() ? &session_->known().trajectory : nullptr,
       .drawn_scans = [this] { return DrawnScans(DrawnInTheEnd()); },
       .loop_closer = options_.close_loops ? &loop_closer_ : nullptr,
       .optimize = [this](const backend::PoseGraph& graph) { return graph_thread_.Run(graph); }});
}

SlamResult ImprovedGmapping::FinishWith(const FinalOptimization::Options& options) {
  backend::PoseGraphRecorder path;
  EmitPath(&path);
  SlamResult estimate = MakeFinalOptimization(options).Finish(path.graph());
  ReportPieces(DrawnInTheEnd());
  ReportClosures(backend::PosesOf(estimate.graph));
  return estimate;
}

SlamResult ImprovedGmapping::Finish() {
  if (!options_.make_final_optimization) return FinishEarly();
  if (const auto optimized = graph_thread_.Finish()) ApplyOptimizedGraph(*optimized);
  return FinishWith(options_.final_optimization);
}

int ImprovedGmapping::EditClosures(const std::vector<loop_closure::ClosureRecord>& edited) {
  graph_thread_.Finish();  // of what was optimized without them nothing is taken
  closure_waits_ = true;
  return loop_closer_.Edit(edited);
}

std::vector<backend::SE2> ImprovedGmapping::OptimizedNodes() {
  backend::PoseGraphRecorder path;
  EmitPath(&path);
  return MakeFinalOptimization(options_.final_optimization).OptimizedNodes(path.graph());
}

loop_closure::ClosureRecord ImprovedGmapping::MeasureClosure(
    const std::vector<backend::SE2>& world_T_nodes, int old_node, int node) const {
  return loop_closer_.Measure(
      world_T_nodes, [this](int k) { return ScanOfNode(k); }, old_node, node);
}

SlamResult ImprovedGmapping::FinishEdited(int refine) {
  FinalOptimization::Options options = options_.final_optimization;
  options.closing_rounds = 0;
  options.review_rounds = 0;
  options.refine = refine;
  return FinishWith(options);
}

}  // namespace gmapping_spa::frontend
