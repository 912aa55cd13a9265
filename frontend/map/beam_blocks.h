// SPDX-License-Identifier: BSD-3-Clause
// The parts of an occupancy grid around the end points of the beams of one scan.
#ifndef GMAPPING_SPA_FRONTEND_MAP_BEAM_BLOCKS_H_
#define GMAPPING_SPA_FRONTEND_MAP_BEAM_BLOCKS_H_

#include <cstddef>
#include <vector>

#include "frontend/map/cell_block.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::map {

// A block a beam, copied when it is first asked for and when the end point has left it. Beams side
// by side end near each other: where the block of the beam asked for before will do, it is shared,
// which saves most copies and keeps what is used in the cache.
class BeamBlocks {
 public:
  explicit BeamBlocks(std::size_t beams) : blocks_(beams) {
    block_of_beam_.reserve(beams);
    for (std::size_t beam = 0; beam < beams; ++beam) block_of_beam_.push_back(beam);
  }

  // A block that covers `cell`, where the beam ends. `grid` is the same in all calls and does not
  // change meanwhile. The reference holds until the next call.
  const CellBlock& Around(const OccupancyGrid& grid, std::size_t beam, CellIndex cell) {
    std::size_t& block = block_of_beam_[beam];
    if (!blocks_[block].Covers(cell)) {
      if (blocks_[last_].Covers(cell)) {
        block = last_;
      } else {
        block = beam;
        blocks_[beam].CopyFrom(grid, cell);
      }
    }
    last_ = block;
    return blocks_[block];
  }

 private:
  std::vector<CellBlock> blocks_;
  std::vector<std::size_t> block_of_beam_;
  std::size_t last_ = 0;  // the block asked for last
};

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_BEAM_BLOCKS_H_
