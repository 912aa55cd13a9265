#include "backend/plugin/optimizer.h"

#include <stdexcept>

namespace gmapping_spa::backend {

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

const char* TerminationName(Termination termination) {
  switch (termination) {
    case Termination::kConverged:
      return "converged";
    case Termination::kNoConvergence:
      return "no_convergence";
    case Termination::kFailure:
      return "failure";
  }
  return "unknown";
}

}  // namespace gmapping_spa::backend
