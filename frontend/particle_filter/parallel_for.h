// SPDX-License-Identifier: BSD-3-Clause
// Work on the particles by several threads.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARALLEL_FOR_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARALLEL_FOR_H_

#include <functional>

namespace gmapping_spa::particle_filter {

// Calls work(0) ... work(count - 1), up to `threads` >= 1 at a time, and returns when all are done.
// Which thread does what is not defined, so items must not share state. When one throws, as for
// want of memory, items that have not begun are left out and one of the exceptions is thrown.
// Threads are made for each call: that costs microseconds, where a step of the filter takes
// milliseconds.
void ParallelFor(int threads, int count, const std::function<void(int)>& work);

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARALLEL_FOR_H_
