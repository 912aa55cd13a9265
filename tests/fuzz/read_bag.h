// SPDX-License-Identifier: BSD-3-Clause
// Bags by their path, as programs read them.
#ifndef GMAPPING_SPA_TESTS_FUZZ_READ_BAG_H_
#define GMAPPING_SPA_TESTS_FUZZ_READ_BAG_H_

#include <string>

#include "frontend/rosbag/open_bag.h"
#include "tests/fuzz/read_log.h"

namespace gmapping_spa::fuzz {

// Of a file or of a folder.
inline void ReadBag(const std::string& path) {
  ReadLog([&](const sensor::LogOptions& options) { return rosbag::OpenBag(path, options).reader; });
}

}  // namespace gmapping_spa::fuzz

#endif  // GMAPPING_SPA_TESTS_FUZZ_READ_BAG_H_
