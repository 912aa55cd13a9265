// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_FILES_H_

#include <filesystem>
#include <functional>
#include <ostream>

namespace gmapping_spa::python {

// Writes one file; its folder is made if need be. Throws std::runtime_error with one line.
void WriteFile(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_FILES_H_
