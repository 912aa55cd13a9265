#include "backend/initialization/initialization.h"

#include <stdexcept>

#include "backend/initialization/chordal_initialization.h"
#include "backend/initialization/initial_guess.h"

namespace gmapping_spa::backend {

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
  switch (initialization) {
    case Initialization::kAuto:
      return "auto";
    case Initialization::kKeep:
      return "keep";
    case Initialization::kOdometry:
      return "odometry";
    case Initialization::kSpanningTree:
      return "spanning_tree";
    case Initialization::kChordal:
      return "chordal";
  }
  return "unknown";
}

Initialization InitializationFromName(const std::string& name) {
  for (const auto initialization :
       {Initialization::kAuto, Initialization::kKeep, Initialization::kOdometry,
        Initialization::kSpanningTree, Initialization::kChordal}) {
    if (name == InitializationName(initialization)) return initialization;
  }
  throw std::runtime_error(
      "expected an initialization out of auto, keep, odometry, spanning_tree, chordal, got '" +
      name + "'");
}

}  // namespace gmapping_spa::backend
