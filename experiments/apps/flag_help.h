// SPDX-License-Identifier: BSD-3-Clause
// What --help and --helpxml print. gflags' own list the flags of all libraries, and know no groups.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_HELP_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_HELP_H_

#include <iosfwd>
#include <string>

#include "experiments/apps/flag_groups.h"

namespace gmapping_spa::apps {

// For people.
void PrintHelp(const std::string& program, const FlagGroups& groups, std::ostream& out);

// For programs: the elements of gflags' --helpxml but <file>, with the flags in elements <group>.
void PrintHelpXml(const std::string& program, const FlagGroups& groups, std::ostream& out);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_HELP_H_
