// SPDX-License-Identifier: BSD-3-Clause
// What every kind of bag is: messages on topics, in the order in which they were recorded.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_MESSAGE_SOURCE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_MESSAGE_SOURCE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gmapping_spa::rosbag {

enum class Encoding : std::uint8_t { kUnknown, kRos1, kCdr };

struct BagTopic {
  std::string name;
  std::string type;  // in the way of ROS 1: "sensor_msgs/LaserScan"
  Encoding encoding = Encoding::kUnknown;
  std::string md5sum;         // of the type, where ROS 1 tells it
  std::int64_t messages = 0;  // as the index of the bag counts them
};

struct BagContents {
  std::string format;  // for people: "ROS 1 bag, 17 chunks"
  std::vector<BagTopic> topics;
  std::int64_t bytes = 0;                  // on the disk
  std::int64_t first_ns = 0, last_ns = 0;  // times of recording; equal for a bag without messages
  // The bag was never closed: it was read through for what its index would tell, and so many bytes
  // at its end are no whole record.
  bool unclosed = false;
  std::int64_t cut_off_bytes = 0;
  std::int64_t missing_files = 0;  // that its metadata.yaml lists
};

struct BagMessage {
  std::size_t topic = 0;     // of BagContents::topics
  std::int64_t time_ns = 0;  // of recording
  std::string_view data;     // until the next message is read
  // Where it is, for messages: the byte of its chunk in the file, or its row in a database.
  const std::string* file = nullptr;
  const char* unit = "byte";
  std::int64_t place = 0;
};

class MessageSource {
 public:
  virtual ~MessageSource() = default;

  virtual const BagContents& contents() const = 0;

  // Goes to the begin and delivers messages of those topics only, `wanted[topic]`.
  virtual void Select(const std::vector<bool>& wanted) = 0;

  // The next message in the order of time of recording, or nothing at the end. Throws BagError.
  virtual std::optional<BagMessage> Next() = 0;
};

// "sensor_msgs/LaserScan" for "sensor_msgs/msg/LaserScan" as well.
std::string Ros1TypeName(std::string_view type);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_MESSAGE_SOURCE_H_
