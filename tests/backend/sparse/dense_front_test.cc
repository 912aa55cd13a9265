// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/dense_front.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

namespace gmapping_spa::spa {
namespace {

// Few rows take loops, many the algorithms of Eigen.
class DenseFrontOfSize : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(DenseFrontOfSize, AgreesWithDenseCholesky) {
  const auto [rows, pivots] = GetParam();
  const int rest = rows - pivots;
  std::srand(1);
  const Eigen::MatrixXd root = Eigen::MatrixXd::Random(rows, rows + 5);
  const Eigen::MatrixXd matrix = root * root.transpose();
  const Eigen::MatrixXd l = matrix.llt().matrixL();
  const Eigen::VectorXd b = Eigen::VectorXd::Random(rows);
  const DenseFront& dense = DenseFrontForThisProcessor();

  Eigen::MatrixXd panel = matrix.leftCols(pivots);
  ASSERT_TRUE(dense.factorize(panel.data(), rows, pivots));
  const Eigen::MatrixXd lower = panel.triangularView<Eigen::Lower>();
  EXPECT_LT((lower - l.leftCols(pivots)).norm(), 1e-10 * l.norm());

  Eigen::MatrixXd update = matrix.bottomRightCorner(rest, rest);
  if (rest > 0) dense.update(panel.data(), rows, pivots, update.data());
  const Eigen::MatrixXd below = l.bottomRightCorner(rest, rest);
  const Eigen::MatrixXd difference = update - below * below.transpose();
  EXPECT_LT(Eigen::MatrixXd(difference.triangularView<Eigen::Lower>()).norm(),
            1e-10 * matrix.norm());

  std::vector<double> columns;
  for (int j = 0; j < pivots; ++j) {
    columns.insert(columns.end(), panel.col(j).begin() + j, panel.col(j).end());
  }
  Eigen::VectorXd x = b;
  dense.substitute(columns.data(), rows, pivots, x.data());
  const Eigen::VectorXd y =
      l.topLeftCorner(pivots, pivots).triangularView<Eigen::Lower>().solve(b.head(pivots));
  EXPECT_LT((x.head(pivots) - y).norm(), 1e-9 * y.norm());
  EXPECT_LT((x.tail(rest) - (b.tail(rest) - l.bottomLeftCorner(rest, pivots) * y)).norm(), 1e-9);

  x.tail(rest) = b.tail(rest);
  dense.substitute_back(columns.data(), rows, pivots, x.data());
  const Eigen::VectorXd right = y - l.bottomLeftCorner(rest, pivots).transpose() * b.tail(rest);
  const Eigen::VectorXd solution =
      l.topLeftCorner(pivots, pivots).transpose().triangularView<Eigen::Upper>().solve(right);
  EXPECT_LT((x.head(pivots) - solution).norm(), 1e-8 * solution.norm());
}

INSTANTIATE_TEST_SUITE_P(FewAndManyRows, DenseFrontOfSize,
                         testing::Values(std::pair(3, 3), std::pair(9, 3), std::pair(40, 17),
                                         std::pair(41, 3), std::pair(120, 120),
                                         std::pair(150, 60)));

TEST(DenseFront, RefusesMatricesThatAreNotPositiveDefinite) {
  for (const int rows : {6, 60}) {
    Eigen::MatrixXd panel = Eigen::MatrixXd::Identity(rows, rows);
    panel(4, 4) = -1.0;
    EXPECT_FALSE(DenseFrontForThisProcessor().factorize(panel.data(), rows, rows));
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
