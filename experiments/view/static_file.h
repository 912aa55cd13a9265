// SPDX-License-Identifier: BSD-3-Clause
// A file that a server has in memory.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_STATIC_FILE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_STATIC_FILE_H_

#include <string_view>

namespace gmapping_spa::view {

struct StaticFile {
  std::string_view path;  // of the request: "/main.js"
  std::string_view content_type;
  std::string_view content;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_STATIC_FILE_H_
