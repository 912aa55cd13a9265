// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/version.h"

namespace gmapping_spa::apps {

// Of the source that commit.cmake writes. What is not linked with it, as tests, has none.
[[gnu::weak]] const char* LinkedCommit();

std::string ReleaseVersion() { return GMAPPING_SPA_VERSION; }

std::string Commit() { return LinkedCommit != nullptr ? LinkedCommit() : "unknown"; }

std::string FullVersion() { return ReleaseVersion() + "+" + Commit(); }

}  // namespace gmapping_spa::apps
