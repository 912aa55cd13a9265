// SPDX-License-Identifier: BSD-3-Clause
// Flags that had another name.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_RENAMED_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_RENAMED_FLAGS_H_

#include <string>

namespace gmapping_spa::apps {

// `flag`: "name", "noname" or "name=value", which stands at `place`. Throws std::runtime_error with
// the new name if the flag is a former one.
void RefuseFormerName(const std::string& place, const std::string& flag);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_RENAMED_FLAGS_H_
