// SPDX-License-Identifier: BSD-3-Clause
// The scans of a session as a log, so that maps of several runs become one.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_LOG_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_LOG_H_

#include <string>

#include "experiments/apps/log_file.h"

namespace gmapping_spa::apps {

// Whether the file begins as a session does.
bool IsSessionFile(const std::string& path);

// Reads the scans that a session has taken, as they were measured; flags about logs (ranges, laser
// pose and the like) had their say when they were read first. Throws std::runtime_error with one
// line when the session is none, does not fit the flags of SLAM, or went on in the map of another:
// such a one holds scans of several logs.
LogFile OpenSessionLog(const std::string& path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_LOG_H_
