// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/stand_still.h"

#include <cmath>
#include <cstddef>

namespace gmapping_spa::frontend {

namespace {

constexpr double kChanged_m = 0.5;
constexpr int kPartChanged = 4;  // one in so many beams
constexpr int kEnoughBeams = 8;

}  // namespace

bool StandStill::IsContradicted(const sensor::LaserScan& scan, bool unchanged) {
  if (!unchanged || first_beams_.size() != scan.beams.size()) {
    first_beams_ = scan.beams;
    return false;
  }
  int hits = 0, changed = 0;
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    const sensor::Beam &before = first_beams_[k], &now = scan.beams[k];
    if (before.status != sensor::BeamStatus::kHit || now.status != sensor::BeamStatus::kHit) {
      continue;
    }
    ++hits;
    changed += std::abs(now.range_m - before.range_m) > kChanged_m ? 1 : 0;
  }
  return hits >= kEnoughBeams && changed * kPartChanged >= hits;
}

}  // namespace gmapping_spa::frontend
