// SPDX-License-Identifier: BSD-3-Clause
// The results of a run, to be looked at.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FINISHED_RUN_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FINISHED_RUN_H_

#include <string>

#include "experiments/view/finished_view.h"

namespace gmapping_spa::apps {

// Of a folder that gmapping_spa wrote: map.yaml and its image, trajectory.tum, graph.g2o,
// graph.stamps, loop_closures.csv, run.json. Of candidates for closures it has nodes, verdict and
// measured pose, no scores.
// Throws std::runtime_error with one line when a file is missing or broken.
view::FinishedRun ReadFinishedRun(const std::string& folder);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FINISHED_RUN_H_
