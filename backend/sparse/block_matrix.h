// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a symmetric matrix with the pattern of a BlockStructure.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_BLOCK_MATRIX_H_
#define GMAPPING_SPA_BACKEND_SPARSE_BLOCK_MATRIX_H_

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "backend/sparse/block_structure.h"

namespace gmapping_spa::spa {

inline constexpr int kLargestSize = 4;  // of a block

template <int kBlockSize>
class BlockMatrix {
 public:
  static constexpr int kSize = kBlockSize;  // rows of a block
  using Block = Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor | Eigen::DontAlign>;
  using Segment = Eigen::Matrix<double, kSize, 1, Eigen::DontAlign>;
  using Vector = std::vector<Segment>;  // one segment for each column of blocks

  BlockMatrix() = default;
  // An empty matrix in the memory of another one, which is empty afterwards: on graphs of the usual
  // size, getting memory from the system takes as long as a factorization.
  template <int kOtherSize>
  explicit BlockMatrix(BlockMatrix<kOtherSize>&& other)
      : diagonal_(std::move(other.diagonal_)), off_diagonal_(std::move(other.off_diagonal_)) {
    diagonal_.clear();
    off_diagonal_.clear();
  }

  // Makes all blocks of the structure zero.
  void SetZero(const BlockStructure& structure) {
    // Memory for the largest blocks at once: growing later would need both at a time.
    diagonal_.reserve(std::size_t{kLargestSize} * kLargestSize * structure.columns());
    off_diagonal_.reserve(std::size_t{kLargestSize} * kLargestSize * structure.blocks());
    diagonal_.assign(kNumbers * structure.columns(), 0.0);
    off_diagonal_.assign(kNumbers * structure.blocks(), 0.0);
  }

  // The block of a column on the diagonal, and that of an entry of BlockStructure::row above it.
  Eigen::Map<Block> diagonal(int column) {
    return Eigen::Map<Block>(diagonal_.data() + kNumbers * column);
  }
  Eigen::Map<Block> off_diagonal(int block) {
    return Eigen::Map<Block>(off_diagonal_.data() + kNumbers * block);
  }
  Eigen::Map<const Block> diagonal(int column) const {
    return Eigen::Map<const Block>(diagonal_.data() + kNumbers * column);
  }
  Eigen::Map<const Block> off_diagonal(int block) const {
    return Eigen::Map<const Block>(off_diagonal_.data() + kNumbers * block);
  }

  // Adds the second derivative of an edge's cost by i and j, in that order.
  void AddOffDiagonal(BlockStructure::Slot slot, const Block& block) {
    if (slot.block < 0) return;
    if (slot.transposed) {
      off_diagonal(slot.block) += block.transpose();
    } else {
      off_diagonal(slot.block) += block;
    }
  }

  // All blocks, one after the other, by rows.
  const double* diagonal_data() const { return diagonal_.data(); }
  const double* off_diagonal_data() const { return off_diagonal_.data(); }

 private:
  template <int kOtherSize>
  friend class BlockMatrix;

  static constexpr std::size_t kNumbers = std::size_t{kSize} * kSize;  // of a block

  std::vector<double> diagonal_;
  std::vector<double> off_diagonal_;
};

// Of the poses (x, y, theta) of a graph.
using PoseMatrix = BlockMatrix<3>;

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_BLOCK_MATRIX_H_
