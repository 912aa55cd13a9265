// SPDX-License-Identifier: BSD-3-Clause
// Sparse structures as dense matrices, in the order of elimination.
#ifndef GMAPPING_SPA_TESTS_BACKEND_SPARSE_DENSE_H_
#define GMAPPING_SPA_TESTS_BACKEND_SPARSE_DENSE_H_

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "backend/cost/edge_error.h"
#include "backend/graph/graph_index.h"
#include "backend/sparse/block_matrix.h"

namespace gmapping_spa::spa {

template <int kSize>
Eigen::MatrixXd Dense(const BlockStructure& structure, const BlockMatrix<kSize>& matrix) {
  Eigen::MatrixXd dense =
      Eigen::MatrixXd::Zero(kSize * structure.columns(), kSize * structure.columns());
  for (int k = 0; k < structure.columns(); ++k) {
    dense.block<kSize, kSize>(kSize * k, kSize * k) = matrix.diagonal(k);
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      const int row = structure.row[p];
      dense.block<kSize, kSize>(kSize * row, kSize * k) = matrix.off_diagonal(p);
      dense.block<kSize, kSize>(kSize * k, kSize * row) = matrix.off_diagonal(p).transpose();
    }
  }
  return dense;
}

template <typename Segment>
Eigen::VectorXd Dense(const std::vector<Segment>& vector) {
  constexpr int kSize = Segment::RowsAtCompileTime;
  Eigen::VectorXd dense(kSize * vector.size());
  for (std::size_t k = 0; k < vector.size(); ++k) dense.segment<kSize>(kSize * k) = vector[k];
  return dense;
}

// A random positive definite matrix with the pattern of the structure.
template <int kSize>
BlockMatrix<kSize> RandomMatrix(const BlockStructure& structure, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  using Block = typename BlockMatrix<kSize>::Block;
  BlockMatrix<kSize> matrix;
  matrix.SetZero(structure);
  const auto any_block = [&] {
    Block block;
    for (double& entry : block.reshaped()) entry = normal(random);
    return block;
  };
  for (int k = 0; k < structure.columns(); ++k) {
    matrix.diagonal(k) += Block::Identity();
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      // An edge's share: J' J for two random Jacobians.
      const Block i = any_block(), j = any_block();
      matrix.diagonal(structure.row[p]) += i.transpose() * i;
      matrix.diagonal(k) += j.transpose() * j;
      matrix.off_diagonal(p) += i.transpose() * j;
    }
  }
  return matrix;
}

template <int kSize>
typename BlockMatrix<kSize>::Vector RandomVector(const BlockStructure& structure, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  typename BlockMatrix<kSize>::Vector vector(structure.columns());
  for (auto& block : vector) {
    for (double& entry : block) entry = normal(random);
  }
  return vector;
}

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_TESTS_BACKEND_SPARSE_DENSE_H_
