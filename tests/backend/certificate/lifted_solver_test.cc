// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/lifted_solver.h"

#include <gtest/gtest.h>

#include "backend/certificate/chordal_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::lifted_solver_test {
namespace {

class LiftedSolverTest : public ::testing::Test {
 protected:
  LiftedSolverTest() {
    structure_.Update(IndexGraph(graph_));
    std::vector<InformationSplit> splits;
    for (const Edge& edge : graph_.edges) splits.push_back(SplitInformation(edge.information));
    matrix_ = ChordalCost(graph_, structure_, splits).Matrix();
    for (int k = 0; k < structure_.blocks().columns(); ++k) {
      right_.push_back(LiftedMatrix::Segment(std::sin(k), std::cos(k), 0.1 * k, 1.0));
    }
  }

  // That x is the solution for the right-hand side, with a shift.
  void ExpectSolution(const LiftedVector& x, double shift) const {
    LiftedVector product = Multiply(structure_.blocks(), matrix_, x);
    for (std::size_t k = 0; k < product.size(); ++k) {
      product[k].tail<2>() += shift * x[k].tail<2>();
      EXPECT_LT((product[k] - right_[k]).norm(), 1e-8);
    }
  }

  PoseGraph graph_ = RandomGraph(3);
  spa::GraphStructure structure_;
  LiftedMatrix matrix_;
  LiftedVector right_;
};

TEST_F(LiftedSolverTest, SolvesOneRightHandSideAfterAnother) {
  LiftedSolver solver;
  for (const double shift : {0.0, 3.0}) {
    LiftedVector x(right_.size(), LiftedMatrix::Segment::Ones());
    ASSERT_TRUE(solver.FactorizeAndSolve(structure_, matrix_, shift, 0.0, &x));
    x = right_;
    solver.Solve(structure_, &x);
    ExpectSolution(x, shift);
    x = right_;
    ASSERT_TRUE(solver.FactorizeAndSolve(structure_, matrix_, shift, 0.0, &x));
    ExpectSolution(x, shift);
  }
}

TEST_F(LiftedSolverTest, RefusesWhatIsNotPositiveDefinite) {
  LiftedSolver solver;
  LiftedVector x = right_;
  EXPECT_FALSE(solver.FactorizeAndSolve(structure_, matrix_, -1e6, 0.0, &x));
  x = right_;
  // A part of the diagonal that leaves nothing of it.
  EXPECT_FALSE(solver.FactorizeAndSolve(structure_, matrix_, 0.0, 1.0, &x));
}

}  // namespace
}  // namespace gmapping_spa::backend::lifted_solver_test
