// SPDX-License-Identifier: BSD-3-Clause
// The back end that the flags of a command line ask for.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_BACKEND_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_BACKEND_FLAGS_H_

#include <functional>
#include <memory>
#include <string>

#include "backend/plugin/optimizer.h"
#include "experiments/apps/flag_groups.h"

namespace gmapping_spa::apps {

FlagGroups BackendFlagGroups();

// The value of --backend: a name or a path.
std::string BackendFromFlags();

// The value of --gnc.
bool GncFromFlags();

// Loads the back end of --backend, and checks that it can do what the flags ask for; throws
// std::runtime_error with one line. Where it does not support what the default loss needs, --loss
// becomes none, with a warning: call this before the flags are read.
std::unique_ptr<backend::Optimizer> LoadOptimizerFromFlags();

// Loads the back end of --backend in any thread, whatever the flags are by then; checks nothing.
std::function<std::unique_ptr<backend::Optimizer>()> OptimizerLoaderFromFlags();

// The options of --loss, --init, ..., with those --<backend>_<setting> flags that were set, and
// with --backend_settings. Throws std::runtime_error with one line.
backend::Options OptionsFromFlags();

// Optimizes as the flags say, by backend::Optimize.
backend::Summary OptimizeAsFlagsSay(backend::Optimizer* optimizer, backend::PoseGraph* graph);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_BACKEND_FLAGS_H_
