// SPDX-License-Identifier: BSD-3-Clause
// What inspect_log says of a bag, besides of its scans.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_BAG_INSPECTION_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_BAG_INSPECTION_H_

#include <ostream>

#include "experiments/apps/json.h"
#include "frontend/rosbag/open_bag.h"

namespace gmapping_spa::apps {

// Topics, which of them are read and for what, frames and lasers.
Json BagToJson(const rosbag::BagReport& bag);

// The same for people.
void PrintBag(const Json& bag, std::ostream& out);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_BAG_INSPECTION_H_
