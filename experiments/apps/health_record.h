// SPDX-License-Identifier: BSD-3-Clause
// What a run noticed, for run.json and for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_HEALTH_RECORD_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_HEALTH_RECORD_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "experiments/apps/json.h"
#include "frontend/health.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::apps {

// By their kinds.
using Findings = std::map<std::string, frontend::Finding>;
using Stretches = std::map<std::string, std::vector<frontend::Stretch>>;

// A count of a log's reader, 0 where the format has no such.
std::int64_t CountOf(const sensor::LogCounts& counts, const std::string& name);

// Those counts of a log's reader that its user should know, by their name; their times are nan,
// since a reader counts only. Nothing of counts that are empty.
Findings FindingsOf(const sensor::LogCounts& counts);

// A warning of one line for each of FindingsOf, for the end of a run.
void WarnOf(const sensor::LogCounts& counts);

// An object for each kind of finding or stretch, {"message", "count", "first_s", "last_s"}; times
// are left out where they are not known. Kinds of stretches ("lost") have {"stretches": [[begin,
// end], ...]} in seconds, too, and count these where nothing else was reported.
Json ToJson(Findings findings, const Stretches& stretches);

// Of a run and of what its log's reader counted.
Json HealthRecord(const frontend::Health& health, const sensor::LogCounts& counts);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_HEALTH_RECORD_H_
