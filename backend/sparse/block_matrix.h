// The blocks of a symmetric matrix with the pattern of a BlockStructure.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_BLOCK_MATRIX_H_
#define GMAPPING_SPA_BACKEND_SPARSE_BLOCK_MATRIX_H_

#include <Eigen/Core>
#include <vector>

#include "backend/sparse/block_structure.h"

namespace gmapping_spa::spa {

inline constexpr int kLargestSize = 4;  // of a block

template <int kSize>
using Block = Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor | Eigen::DontAlign>;

template <int kSize>
using BlockVector = Eigen::Matrix<double, kSize, 1, Eigen::DontAlign>;

// One object serves for blocks of different sizes in turn and keeps its memory: on graphs of the
// usual size, getting memory from the system takes as long as a factorization.
class BlockMatrix {
 public:
  // Makes all blocks of the structure zero matrices of kSize rows.
  template <int kSize>
  void SetZero(const BlockStructure& structure) {
    // Memory for the largest blocks at once: growing later would need both at a time.
    diagonal_.reserve(std::size_t{kLargestSize} * kLargestSize * structure.columns());
    off_diagonal_.reserve(std::size_t{kLargestSize} * kLargestSize * structure.blocks());
    diagonal_.assign(std::size_t{kSize} * kSize * structure.columns(), 0.0);
    off_diagonal_.assign(std::size_t{kSize} * kSize * structure.blocks(), 0.0);
  }

  // The block of a column on the diagonal, and that of an entry of BlockStructure::row above it.
  // kSize is that of the last SetZero.
  template <int kSize>
  Eigen::Map<Block<kSize>> diagonal(int column) {
    return Eigen::Map<Block<kSize>>(diagonal_.data() + std::size_t{kSize} * kSize * column);
  }
  template <int kSize>
  Eigen::Map<Block<kSize>> off_diagonal(int block) {
    return Eigen::Map<Block<kSize>>(off_diagonal_.data() + std::size_t{kSize} * kSize * block);
  }
  template <int kSize>
  Eigen::Map<const Block<kSize>> diagonal(int column) const {
    return Eigen::Map<const Block<kSize>>(diagonal_.data() + std::size_t{kSize} * kSize * column);
  }
  template <int kSize>
  Eigen::Map<const Block<kSize>> off_diagonal(int block) const {
    return Eigen::Map<const Block<kSize>>(off_diagonal_.data() +
                                          std::size_t{kSize} * kSize * block);
  }

  // Adds the second derivative of an edge's cost by i and j, in that order.
  template <int kSize>
  void AddOffDiagonal(BlockStructure::Slot slot, const Block<kSize>& block) {
    if (slot.block < 0) return;
    if (slot.transposed) {
      off_diagonal<kSize>(slot.block) += block.transpose();
    } else {
      off_diagonal<kSize>(slot.block) += block;
    }
  }

  // All blocks, one after the other, by rows.
  const double* diagonal_data() const { return diagonal_.data(); }
  const double* off_diagonal_data() const { return off_diagonal_.data(); }

 private:
  std::vector<double> diagonal_;
  std::vector<double> off_diagonal_;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_BLOCK_MATRIX_H_
