// SPDX-License-Identifier: BSD-3-Clause
// The files of page/, which are part of the program: it needs no network and no installed files.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_FILES_H_

#include <vector>

#include "experiments/view/static_file.h"

namespace gmapping_spa::view {

// As they were when the program was built; "/" is index.html.
std::vector<StaticFile> PageFiles();

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_FILES_H_
