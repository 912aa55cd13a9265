// SPDX-License-Identifier: BSD-3-Clause
#include "backend/initialization/initialization.h"

#include "backend/enum_names.h"
#include "backend/graph/initial_guess.h"
#include "backend/initialization/chordal_initialization.h"

namespace gmapping_spa::backend {
namespace {

constexpr EnumName<Initialization> kNames[] = {{"auto", Initialization::kAuto},
                                               {"keep", Initialization::kKeep},
                                               {"odometry", Initialization::kOdometry},
                                               {"spanning_tree", Initialization::kSpanningTree},
                                               {"chordal", Initialization::kChordal}};

}  // namespace

std::optional<std::vector<SE2>> InitialPoses(Initialization initialization,
                                             const PoseGraphView& graph, const GraphIndex& index) {
  std::vector<SE2> poses = PosesOf(graph);
  switch (initialization) {
    case Initialization::kAuto:
    case Initialization::kKeep:
      break;
    case Initialization::kOdometry:
      InitializeFromOdometry(graph, index, &poses);
      break;
    case Initialization::kSpanningTree:
      InitializeFromSpanningTree(graph, index, &poses);
      break;
    case Initialization::kChordal: {
      spa::GraphStructure structure;
      structure.Update(index);
      spa::SolverMemory memory;
      if (!spa::InitializeChordal(graph, structure, &memory, &poses)) return std::nullopt;
    }
  }
  return poses;
}

const char* InitializationName(Initialization initialization) {
  return NameOf(kNames, initialization);
}

Initialization InitializationFromName(const std::string& name) {
  return FromName(kNames, name, "an initialization");
}

}  // namespace gmapping_spa::backend
