// SPDX-License-Identifier: BSD-3-Clause
// The files of the page beyond those of the live view, which CMake puts into page_files.cc.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_PAGE_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_PAGE_FILES_H_

#include <vector>

#include "experiments/view/static_file.h"

namespace gmapping_spa::drive {

std::vector<view::StaticFile> PageFiles();

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_PAGE_FILES_H_
