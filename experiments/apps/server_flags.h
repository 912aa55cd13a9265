// SPDX-License-Identifier: BSD-3-Clause
// Flags of the server of a page: where it is.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SERVER_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SERVER_FLAGS_H_

#include <cstdint>

#include "experiments/apps/flag_groups.h"
#include "experiments/view/view_server.h"

namespace gmapping_spa::apps {

FlagGroups ServerFlagGroups();

// Throws std::runtime_error with one line.
view::ServerOptions ServerOptionsFromFlags();

// On stderr, for people and programs: "view: http://..."
void SayWhereThePageIs(std::uint16_t port);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SERVER_FLAGS_H_
