// The blocks of a symmetric matrix with the pattern of a BlockStructure.
#ifndef GMAPPING_SPA_PLUGINS_SPA_BLOCK_MATRIX_H_
#define GMAPPING_SPA_PLUGINS_SPA_BLOCK_MATRIX_H_

#include <Eigen/Core>
#include <vector>

#include "plugins/spa/block_structure.h"

namespace gmapping_spa::spa {

template <int kSize>
using Block = Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor | Eigen::DontAlign>;

template <int kSize>
using BlockVector = Eigen::Matrix<double, kSize, 1, Eigen::DontAlign>;

template <int kSize>
struct BlockMatrix {
  std::vector<Block<kSize>> diagonal;      // one for each column
  std::vector<Block<kSize>> off_diagonal;  // one for each block of the structure

  void SetZero(const BlockStructure& structure) {
    diagonal.assign(structure.columns(), Block<kSize>::Zero());
    off_diagonal.assign(structure.blocks(), Block<kSize>::Zero());
  }

  // Adds the second derivative of an edge's cost by i and j, in that order.
  void AddOffDiagonal(BlockStructure::Slot slot, const Block<kSize>& block) {
    if (slot.block < 0) return;
    if (slot.transposed) {
      off_diagonal[slot.block] += block.transpose();
    } else {
      off_diagonal[slot.block] += block;
    }
  }
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_PLUGINS_SPA_BLOCK_MATRIX_H_
