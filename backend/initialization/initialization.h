// SPDX-License-Identifier: BSD-3-Clause
// Where an optimization starts.
#ifndef GMAPPING_SPA_BACKEND_INITIALIZATION_INITIALIZATION_H_
#define GMAPPING_SPA_BACKEND_INITIALIZATION_INITIALIZATION_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

enum class Initialization : std::uint8_t {
  kAuto,          // the back end's own choice
  kKeep,          // the given poses
  kOdometry,      // see InitializeFromOdometry
  kSpanningTree,  // see InitializeFromSpanningTree
  kChordal        // the chordal relaxation of Carlone et al. 2015
};

// The poses, one for each node, from which an optimization starts: those of the graph for kAuto and
// kKeep. Fixed nodes stay. Returns nothing when the edges do not determine the chordal relaxation.
std::optional<std::vector<SE2>> InitialPoses(Initialization initialization,
                                             const PoseGraphView& graph, const GraphIndex& index);

// Names as used on command lines: auto, keep, odometry, spanning_tree, chordal.
// InitializationFromName throws std::runtime_error with one line.
const char* InitializationName(Initialization initialization);
Initialization InitializationFromName(const std::string& name);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_INITIALIZATION_INITIALIZATION_H_
