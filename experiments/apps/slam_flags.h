// Flags of the SLAM algorithm.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_FLAGS_H_

#include <memory>

#include "frontend/improved_gmapping.h"
#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/scan_matcher.h"

namespace gmapping_spa::apps {

// Each throws std::runtime_error with one line when a flag makes no sense.
frontend::ImprovedGmapping::Options SlamOptionsFromFlags();
std::shared_ptr<const scan_matching::ScanMatcher> ScanMatcherFromFlags();
scan_matching::EndpointModel::Options EndpointOptionsFromFlags();
double OccupiedThresholdFromFlags();

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_FLAGS_H_
