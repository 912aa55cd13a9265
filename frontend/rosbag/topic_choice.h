// SPDX-License-Identifier: BSD-3-Clause
// Which topics of a bag are read, and for what.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_TOPIC_CHOICE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_TOPIC_CHOICE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/rosbag/message_source.h"
#include "frontend/rosbag/ros_messages.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::rosbag {

struct TopicChoice {
  std::vector<MessageType> use;  // of each topic; kOther: it is not read
  bool has_tf = false;
  bool odometry_from_tf = false;
  // How many topics had scans or odometry, where one was taken by its usual name.
  std::int64_t scan_topics = 0, odometry_topics = 0;
};

// Topics are found by their type. Of several with scans (or odometry) it is the one that the
// options name, else /scan (/odom), which is as good a guess as any and is counted. Without
// odometry, or where the options name a topic of transforms for it, it comes from tf. Throws
// std::runtime_error with one line where there are no scans, several and none of them /scan, not
// the topic that the options name, or a topic that would be read is of another definition or
// encoding. `name` stands for the bag.
TopicChoice ChooseTopics(const BagContents& contents, const std::string& name,
                         const sensor::LogOptions& options);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_TOPIC_CHOICE_H_
