// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/open_bag.h"

#include <utility>

#include "frontend/rosbag/bag_reader.h"
#include "frontend/rosbag/open_source.h"
#include "frontend/sensor/log_pipeline.h"

namespace gmapping_spa::rosbag {

Bag OpenBag(const std::string& path, const sensor::LogOptions& options) {
  sensor::CheckOptions(options);
  auto report = std::make_shared<BagReport>();
  auto records = std::make_unique<BagReader>(OpenSource(path), path, options, report);
  return {sensor::ScansOf(std::move(records), path, options), std::move(report)};
}

}  // namespace gmapping_spa::rosbag
