// What a run noticed, for run.json and for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_HEALTH_RECORD_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_HEALTH_RECORD_H_

#include <map>
#include <string>

#include "experiments/apps/json.h"
#include "frontend/health.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::apps {

// Those counts of a log's reader that its user should know, by their name; their times are nan,
// since a reader counts only. Nothing of counts that are empty.
std::map<std::string, frontend::Finding> FindingsOf(const sensor::LogCounts& counts);

// A warning of one line for each of FindingsOf, for the end of a run.
void WarnOf(const sensor::LogCounts& counts);

// An object for each kind of finding or stretch, {"message", "count", "first_s", "last_s"}; times
// are left out where they are not known. Kinds of stretches ("lost") have {"stretches": [[begin,
// end], ...]} in seconds, too, and count these where nothing else was reported.
Json HealthRecord(const frontend::Health& health, const sensor::LogCounts& counts);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_HEALTH_RECORD_H_
