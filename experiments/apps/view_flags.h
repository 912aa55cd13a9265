// SPDX-License-Identifier: BSD-3-Clause
// Flags of the view of a run, live or finished.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_VIEW_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_VIEW_FLAGS_H_

#include <memory>
#include <string>

#include "experiments/apps/flag_groups.h"
#include "experiments/view/live_view.h"

namespace gmapping_spa::apps {

FlagGroups ViewFlagGroups();

// --view alone is --view=live: gflags wants a value of each flag that is not a bool. Call it before
// RunApp.
void CompleteViewFlag(int argc, char** argv);

// Whether --view names folders of results.
bool ViewsFinishedRuns();

// Shows them until the user wants the program to end. Throws std::runtime_error with one line.
void ViewFinishedRuns();

// Null without --view. Waits for the first page with --view_wait. `name` is that of the log.
std::unique_ptr<view::LiveView> LiveViewFromFlags(const std::string& name, double resolution_m);

// After the run, with its results written: keeps the view with --view_keep.
void EndLiveView(view::LiveView* live_view);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_VIEW_FLAGS_H_
