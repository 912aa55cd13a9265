// SPDX-License-Identifier: BSD-3-Clause
// Which version of the project a program is.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_VERSION_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_VERSION_H_

#include <string>

namespace gmapping_spa::apps {

// Of the project: "0.1.0".
std::string ReleaseVersion();

// What `git describe --always --dirty` said when the program was linked; "unknown" where there was
// no repository.
std::string Commit();

// Both, as Semantic Versioning writes it: "0.1.0+6f639d6-dirty".
std::string FullVersion();

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_VERSION_H_
