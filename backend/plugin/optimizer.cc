// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/optimizer.h"

#include <stdexcept>

#include "backend/enum_names.h"

namespace gmapping_spa::backend {
namespace {

constexpr EnumName<Termination> kNames[] = {{"converged", Termination::kConverged},
                                            {"no_convergence", Termination::kNoConvergence},
                                            {"failure", Termination::kFailure}};

}  // namespace

std::vector<Eigen::Matrix3d> Optimizer::Covariances(std::span<const Edge> /*edges*/,
                                                    std::span<const Node> /*nodes*/,
                                                    std::span<const EdgeNodes> /*pairs*/) {
  throw std::runtime_error("the back end has no covariances of its own");
}

void Optimizer::SetState(const std::string& /*state*/) {
  throw std::runtime_error("this is no state of the back end");
}

std::runtime_error NoCovariances() {
  return std::runtime_error(
      "the covariances do not exist: the information of the edges does not determine all poses");
}

bool KeepsStart(const Options& options) {
  if (options.initialization == Initialization::kAuto) return false;
  if (options.initialization == Initialization::kKeep) return true;
  throw std::invalid_argument(std::string("the initialization ") +
                              InitializationName(options.initialization) +
                              " is that of OptimizeSafely, not of an optimizer");
}

std::chrono::steady_clock::time_point DeadlineOf(const Options& options) {
  using Clock = std::chrono::steady_clock;
  constexpr double kLongest_s = 1e9;  // the clock's nanoseconds overflow at ten times as many
  if (!(options.max_solver_time_s < kLongest_s)) return Clock::time_point::max();
  const std::chrono::duration<double> time(options.max_solver_time_s);
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
}

const char* TerminationName(Termination termination) { return NameOf(kNames, termination); }

}  // namespace gmapping_spa::backend
