// SPDX-License-Identifier: BSD-3-Clause
// Flags of sessions: writing a run in the middle, and going on with it.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_FLAGS_H_

#include <memory>

#include "experiments/apps/flag_groups.h"
#include "experiments/apps/session_saver.h"
#include "experiments/apps/slam_run.h"

namespace gmapping_spa::apps {

FlagGroups SessionFlagGroups();

// With --resume, makes `slam` go on from there; with --map_session, in the map of that. Throws
// std::runtime_error with one line when the file is no session, or one of another version or with
// other flags.
void BeginAsFlagsSay(SlamRun* slam);

// Nothing without --save_session; otherwise `slam` is told. Throws like SessionSaver, and when the
// flags make no sense.
std::unique_ptr<SessionSaver> MakeSessionSaver(SlamRun* slam);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_FLAGS_H_
