// SPDX-License-Identifier: BSD-3-Clause
// What becomes of memory that is freed.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FREED_MEMORY_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FREED_MEMORY_H_

#include <cstdlib>  // __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gmapping_spa::apps {

// Loop closing and scan matching ask for megabytes again and again. By default the C library
// returns them to the system each time, which then clears every page anew: a fifth of the CPU time.
// From this call on the process keeps them.
inline void KeepFreedMemory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that it takes
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FREED_MEMORY_H_
