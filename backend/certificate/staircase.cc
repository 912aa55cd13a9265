// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/staircase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "backend/certificate/lifted_bound.h"
#include "backend/certificate/lifted_descent.h"
#include "backend/cost/graph_cost.h"
#include "backend/counter_random.h"

namespace gmapping_spa::backend {
namespace {

// After a descent, a cost that is lower by less than this part is the same.
constexpr double kLeastDecrease = 1e-9;
constexpr int kMaxDescents = 5;
constexpr LiftedDescent::Options kLowest{.max_products = 1000, .cost_tolerance = 1e-7};
constexpr double kLargestTurn = 0.5;   // out of the plane, at the begin of a descent
constexpr double kOtherColumns = 0.1;  // of it, in the columns beyond the second

Options MinimizerOptions() {
  Options options;
  options.initialization = Initialization::kKeep;
  options.cost_tolerance = 1e-12;
  options.max_iterations = 300;
  return options;
}

// Moves poses along the direction, in the second column, and a little in those beyond it, which
// would stay zero for ever.
void Leave(const spa::GraphStructure& structure, const LiftedVector& direction,
           LiftedPoses* lifted) {
  double largest = 0.0;
  for (const LiftedMatrix::Segment& segment : direction) {
    largest = std::max(largest, segment.tail<2>().norm());
  }
  const double scale = kLargestTurn / largest;
  CounterRandom random(/*seed=*/2, /*stream=*/0);
  const std::vector<int>& nodes = structure.blocks().node_of_column;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const LiftedMatrix::Segment& x = direction[k];
    const Eigen::Index row = RowOf(nodes[k]);
    (*lifted)(row, 1) = scale * Complex(x[0], x[1]);
    (*lifted)(row + 1, 1) = scale * Complex(x[2], x[3]);
    for (Eigen::Index c = 2; c < lifted->cols(); ++c) {
      const double factor = kOtherColumns * random.Gaussian();
      (*lifted)(row, c) = factor * (*lifted)(row, 1);
      (*lifted)(row + 1, c) = factor * (*lifted)(row + 1, 1);
    }
    lifted->row(row + 1).normalize();
  }
}

LiftedVector AnyDirection(const spa::GraphStructure& structure) {
  CounterRandom random(/*seed=*/3, /*stream=*/0);
  LiftedVector direction(structure.blocks().columns());
  for (LiftedMatrix::Segment& segment : direction) {
    segment << 0.0, 0.0, random.Gaussian(), random.Gaussian();
  }
  return direction;
}

class Staircase {
 public:
  Staircase(Optimizer* optimizer, const PoseGraph& graph)
      : optimizer_(optimizer),
        graph_(graph),
        certifier_(graph_),
        cost_(graph_, certifier_.structure(), certifier_.splits()),
        poses_(PosesOf(graph)) {
    result_.certificate = certifier_.Certify(poses_);
    result_.initial_cost = result_.certificate.cost;
    result_.first_gap = result_.certificate.relative_gap;
  }

  StaircaseResult* result() { return &result_; }
  const std::vector<SE2>& poses() const { return poses_; }
  bool optimal() const { return result_.certificate.optimal(); }

  // What can be proved where the poses could not be proved to be optimal.
  void CompleteCertificate() {
    Certificate& certificate = result_.certificate;
    if (optimal()) return;
    certifier_.NegativeCurvature(&certificate);
    if (lowest_.size() == 0) return;
    LiftedDescent(certifier_.structure(), cost_).Minimize(kLowest, &lowest_);
    LiftedSolver solver;
    const double bound =
        LiftedBound(certifier_.structure(), cost_, lowest_, certificate.margin, &solver);
    if (bound <= certificate.lower_bound) return;
    certificate.lower_bound = std::min(bound, certificate.cost);
    certificate.relative_gap = 1.0 - certificate.lower_bound / certificate.cost;
  }

  // The optimizer goes on from the best poses.
  void GoOn() { TryFrom(poses_, 0); }

  // Descends in that many dimensions. False when that leads nowhere.
  bool Descend(int rank) {
    if (result_.certificate.positive_definite) return false;
    const std::optional<LiftedVector> direction =
        certifier_.NegativeCurvature(&result_.certificate);
    LiftedPoses lifted = LiftPoses(poses_, rank / 2);
    // Where an angle is off by pi, the matrix is not finite, and any direction has to do.
    Leave(certifier_.structure(), direction ? *direction : AnyDirection(certifier_.structure()),
          &lifted);
    const double cost = LiftedDescent(certifier_.structure(), cost_).Minimize({}, &lifted);
    std::vector<SE2> rounded = poses_;
    if (!RoundPoses(graph_, certifier_.structure(), lifted, &rounded)) return false;
    TryFrom(rounded, rank);
    if (cost < lowest_cost_) {
      lowest_cost_ = cost;
      lowest_ = std::move(lifted);
    }
    return true;
  }

 private:
  // The optimizer's poses from a start, accepted and certified when they cost less.
  void TryFrom(const std::vector<SE2>& start, int rank) {
    PoseGraph trial = graph_;
    for (std::size_t k = 0; k < start.size(); ++k) trial.nodes[k].world_T_node = start[k];
    optimizer_->Optimize(MinimizerOptions(), trial.edges, trial.nodes);
    std::vector<SE2> poses = PosesOf(trial);
    Descent descent{.rank = rank, .cost = GraphCost(graph_, certifier_.structure().index(), poses)};
    const double largest = rank == 0 ? 1.0 : 1.0 - kLeastDecrease;
    descent.accepted = descent.cost < largest * result_.certificate.cost;
    result_.descents.push_back(descent);
    if (!descent.accepted) return;
    poses_ = std::move(poses);
    result_.certificate = certifier_.Certify(poses_);
  }

  Optimizer* optimizer_;
  const PoseGraph graph_;
  Certifier certifier_;
  ChordalCost cost_;
  std::vector<SE2> poses_;
  StaircaseResult result_;
  LiftedPoses lowest_;  // lifted poses of the lowest chordal cost so far
  double lowest_cost_ = std::numeric_limits<double>::infinity();
};

}  // namespace

StaircaseResult ClimbStaircase(const StaircaseOptions& options, Optimizer* optimizer,
                               PoseGraph* graph) {
  Staircase staircase(optimizer, *graph);
  if (options.descend && !staircase.optimal()) staircase.GoOn();
  int rank = 4;
  for (int round = 0; options.descend && round < kMaxDescents && !staircase.optimal(); ++round) {
    if (rank > options.last_rank || !staircase.Descend(rank)) break;
    if (!staircase.result()->descents.back().accepted) rank += 2;
  }
  staircase.CompleteCertificate();
  for (std::size_t k = 0; k < graph->nodes.size(); ++k) {
    graph->nodes[k].world_T_node = staircase.poses()[k];
  }
  return *staircase.result();
}

}  // namespace gmapping_spa::backend
