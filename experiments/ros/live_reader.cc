// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/live_reader.h"

#include <optional>
#include <utility>
#include <vector>

#include "experiments/ros/node_flags.h"
#include "frontend/rosbag/bag_reader.h"
#include "frontend/sensor/log_validator.h"
#include "frontend/sensor/time_ordered_reader.h"

namespace gmapping_spa::ros {
namespace {

// A reader owns its source.
class SharedSource : public rosbag::MessageSource {
 public:
  explicit SharedSource(LiveSource* source) : source_(source) {}
  const rosbag::BagContents& contents() const override { return source_->contents(); }
  void Select(const std::vector<bool>& wanted) override { source_->Select(wanted); }
  std::optional<rosbag::BagMessage> Next() override { return source_->Next(); }

 private:
  LiveSource* source_;
};

}  // namespace

std::unique_ptr<sensor::LogReader> MakeLiveReader(LiveSource* source) {
  const sensor::LogOptions options = LogOptionsOfNode();
  auto records =
      std::make_unique<rosbag::BagReader>(std::make_unique<SharedSource>(source), "live", options,
                                          std::make_shared<rosbag::BagReport>());
  sensor::TimeOrderedReader ordered(std::move(records), "live", options);
  return std::make_unique<sensor::LogValidator>(std::move(ordered), "live", options);
}

}  // namespace gmapping_spa::ros
