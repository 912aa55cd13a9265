// SPDX-License-Identifier: BSD-3-Clause
// From the options of SLAM to its parts: what several parts share is handed down here, and only
// here.
#ifndef GMAPPING_SPA_FRONTEND_SLAM_PARTS_H_
#define GMAPPING_SPA_FRONTEND_SLAM_PARTS_H_

#include <memory>

#include "backend/plugin/optimizer.h"
#include "frontend/api/slam_options.h"
#include "frontend/graph_thread.h"
#include "frontend/improved_gmapping.h"
#include "frontend/scan_matching/scan_matcher.h"

namespace gmapping_spa::frontend {

ImprovedGmapping::Options GmappingOptions(const SlamOptions& options);

// The matcher of the particles.
std::shared_ptr<const scan_matching::ScanMatcher> MakeScanMatcher(const SlamOptions& options);

// `optimizer`, held to its contract, with the options of the back end.
GraphThread::OptimizeFunction BindOptimizer(const SlamOptions& options,
                                            std::shared_ptr<backend::Optimizer> optimizer);

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SLAM_PARTS_H_
