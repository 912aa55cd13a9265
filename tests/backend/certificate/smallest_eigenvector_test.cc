// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/smallest_eigenvector.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "backend/certificate/chordal_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::smallest_eigenvector_test {
namespace {

class SmallestEigenvectorTest : public ::testing::Test {
 protected:
  SmallestEigenvectorTest() {
    structure_.Update(IndexGraph(graph_));
    std::vector<InformationSplit> splits;
    for (const Edge& edge : graph_.edges) splits.push_back(SplitInformation(edge.information));
    matrix_ = ChordalCost(graph_, structure_, splits).Matrix();
  }

  // Adds to the diagonal of all rotations.
  void Add(double shift) {
    for (int k = 0; k < structure_.blocks().columns(); ++k) {
      matrix_.diagonal(k).diagonal().tail<2>().array() += shift;
    }
  }

  // The smallest eigenvalue of what is left when positions are where the rotations want them.
  double SmallestEigenvalue() const {
    const int columns = structure_.blocks().columns();
    Eigen::MatrixXd dense(4 * columns, 4 * columns);
    for (int k = 0; k < 4 * columns; ++k) {
      LiftedVector unit(columns, LiftedMatrix::Segment::Zero());
      unit[k / 4][k % 4] = 1.0;
      const LiftedVector column = Multiply(structure_.blocks(), matrix_, unit);
      for (int row = 0; row < columns; ++row) {
        for (int c = 0; c < 4; ++c) {  // positions first
          const auto place = [&](int node, int part) {
            return part < 2 ? 2 * node + part : 2 * columns + 2 * node + part - 2;
          };
          dense(place(row, c), place(k / 4, k % 4)) = column[row][c];
        }
      }
    }
    const int half = 2 * columns;
    const Eigen::MatrixXd reduced =
        dense.bottomRightCorner(half, half) -
        dense.bottomLeftCorner(half, half) *
            dense.topLeftCorner(half, half).llt().solve(dense.topRightCorner(half, half));
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(reduced).eigenvalues()(0);
  }

  PoseGraph graph_ = RandomGraph(8, {.nodes = 20});
  spa::GraphStructure structure_;
  LiftedMatrix matrix_;
  LiftedSolver solver_;
};

TEST_F(SmallestEigenvectorTest, IsTheDirectionOfNegativeCurvature) {
  for (const double shift : {100.0, 1000.0, 10000.0}) {
    Add(-shift);
    const double expected = SmallestEigenvalue();
    ASSERT_LT(expected, 0.0);
    const auto found = FindSmallestEigenvector(structure_, matrix_, 1e-12, &solver_);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->eigenvalue, expected, 0.05 * std::abs(expected));
    EXPECT_GT(found->shift, -expected);
    EXPECT_LT(found->shift, -2.0 * expected);
    EXPECT_NEAR(Dot(found->vector, Multiply(structure_.blocks(), matrix_, found->vector)),
                found->eigenvalue, 1e-9 * shift);
  }
}

TEST_F(SmallestEigenvectorTest, HasAPositiveEigenvalueWhereTheMatrixIsPositiveDefinite) {
  const auto found = FindSmallestEigenvector(structure_, matrix_, 1e-12, &solver_);
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->eigenvalue, 0.0);
}

TEST_F(SmallestEigenvectorTest, IsNothingWhereNoShiftHelps) {
  matrix_.diagonal(3)(0, 0) = -1.0;  // of a position
  EXPECT_FALSE(FindSmallestEigenvector(structure_, matrix_, 1e-12, &solver_).has_value());
  matrix_.diagonal(3)(2, 2) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(FindSmallestEigenvector(structure_, matrix_, 1e-12, &solver_).has_value());
}

}  // namespace
}  // namespace gmapping_spa::backend::smallest_eigenvector_test
