// SPDX-License-Identifier: BSD-3-Clause
// The largest set of measurements all of which go together.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CONSISTENT_SET_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CONSISTENT_SET_H_

#include <functional>
#include <vector>

namespace gmapping_spa::loop_closure {

inline constexpr int kMaxConsistentSet = 64;

// Pairwise consistency maximization (Mangelson et al. 2018): the largest subset of 0 ... count - 1
// in which `consistent` holds of every pair, in ascending order; the first one found where several
// are as large. `consistent` is symmetric. A maximum clique by branch and bound with coloring
// (Tomita and Seki 2003), given up after a number of steps that only contrived graphs need: then
// the largest one so far. Precondition: count <= kMaxConsistentSet.
std::vector<int> LargestConsistentSet(int count, const std::function<bool(int, int)>& consistent);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CONSISTENT_SET_H_
