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
Eigen::MatrixXd Dense(const BlockStructure& structure, const BlockMatrix& matrix) {
  Eigen::MatrixXd dense =
      Eigen::MatrixXd::Zero(kSize * structure.columns(), kSize * structure.columns());
  for (int k = 0; k < structure.columns(); ++k) {
    dense.block<kSize, kSize>(kSize * k, kSize * k) = matrix.diagonal<kSize>(k);
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      const int row = structure.row[p];
      dense.block<kSize, kSize>(kSize * row, kSize * k) = matrix.off_diagonal<kSize>(p);
      dense.block<kSize, kSize>(kSize * k, kSize * row) = matrix.off_diagonal<kSize>(p).transpose();
    }
  }
  return dense;
}

template <int kSize>
Eigen::VectorXd Dense(const std::vector<BlockVector<kSize>>& vector) {
  Eigen::VectorXd dense(kSize * vector.size());
  for (std::size_t k = 0; k < vector.size(); ++k) dense.segment<kSize>(kSize * k) = vector[k];
  return dense;
}

// A random positive definite matrix with the pattern of the structure.
template <int kSize>
BlockMatrix RandomMatrix(const BlockStructure& structure, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  BlockMatrix matrix;
  matrix.SetZero<kSize>(structure);
  const auto any_block = [&] {
    Block<kSize> block;
    for (double& entry : block.reshaped()) entry = normal(random);
    return block;
  };
  for (int k = 0; k < structure.columns(); ++k) {
    matrix.diagonal<kSize>(k) += Block<kSize>::Identity();
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      // An edge's share: J' J for two random Jacobians.
      const Block<kSize> i = any_block(), j = any_block();
      matrix.diagonal<kSize>(structure.row[p]) += i.transpose() * i;
      matrix.diagonal<kSize>(k) += j.transpose() * j;
      matrix.off_diagonal<kSize>(p) += i.transpose() * j;
    }
  }
  return matrix;
}

template <int kSize>
std::vector<BlockVector<kSize>> RandomVector(const BlockStructure& structure, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<BlockVector<kSize>> vector(structure.columns());
  for (auto& block : vector) {
    for (double& entry : block) entry = normal(random);
  }
  return vector;
}

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_TESTS_BACKEND_SPARSE_DENSE_H_
