// SPDX-License-Identifier: BSD-3-Clause
#include "backend/spa/damped_solver.h"

#include <gtest/gtest.h>

#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

// A random graph's normal equations at its poses, and the same as dense matrices.
class DampedSolverTest : public testing::Test {
 protected:
  void Linearized(unsigned seed) {
    const backend::PoseGraph graph = backend::RandomGraph(seed);
    structure_.Update(IndexGraph(graph));
    Linearize(graph, structure_.index(), structure_.blocks(), PosesOf(graph), {},
              &memory_.equations);
    hessian_ = Dense(structure_.blocks(), memory_.equations.hessian);
    minus_gradient_ = Dense(memory_.equations.minus_gradient);
  }

  GraphStructure structure_;
  SolverMemory memory_;
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd minus_gradient_;
};

TEST_F(DampedSolverTest, SolvesEq5AsDenseCholeskyDoes) {
  DampedSolver solver;
  for (unsigned seed = 0; seed < 5; ++seed) {
    Linearized(seed);
    for (const double lambda : {0.0, 1e-3, 10.0}) {
      PoseMatrix::Vector step;
      ASSERT_TRUE(solver.Solve(structure_, lambda, LinearSolver::kBlock, &memory_, &step));
      Eigen::MatrixXd damped = hessian_;
      damped.diagonal() *= 1.0 + lambda;
      const Eigen::VectorXd expected = damped.llt().solve(minus_gradient_);
      EXPECT_LT((Dense(step) - expected).norm(), 1e-9 * (1.0 + expected.norm()));
      // The equations are as they were.
      EXPECT_EQ(Dense(structure_.blocks(), memory_.equations.hessian), hessian_);
    }
  }
}

TEST_F(DampedSolverTest, PredictsByHowMuchTheQuadraticModelFalls) {
  Linearized(3);
  DampedSolver solver;
  for (const double lambda : {0.0, 0.5}) {
    PoseMatrix::Vector blocks;
    ASSERT_TRUE(solver.Solve(structure_, lambda, LinearSolver::kBlock, &memory_, &blocks));
    const Eigen::VectorXd step = Dense(blocks);
    const double decrease = minus_gradient_.dot(step) - 0.5 * step.dot(hessian_ * step);
    EXPECT_NEAR(PredictedDecrease(memory_.equations, lambda, blocks), decrease, 1e-9 * decrease);
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
