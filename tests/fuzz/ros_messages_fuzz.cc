// SPDX-License-Identifier: BSD-3-Clause
// Messages of ROS 1 and ROS 2, out of a bag whose container is whole: each is, in the input, a byte
// for its topic, the time of recording in 8 bytes, its length in 2 and its own bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/rosbag/bag_reader.h"
#include "frontend/rosbag/byte_cursor.h"
#include "frontend/sensor/log_pipeline.h"
#include "tests/fuzz/read_log.h"

namespace gmapping_spa::fuzz {
namespace {

const std::string kName = "bag";

class Messages : public rosbag::MessageSource {
 public:
  // A message that is cut off ends with the input.
  explicit Messages(std::string_view bytes) {
    contents_.bytes = static_cast<std::int64_t>(bytes.size());
    constexpr std::size_t kHeaderBytes = 1 + 8 + 2;
    for (rosbag::ByteCursor rest(bytes, kName, 0); rest.size() >= kHeaderBytes;) {
      const auto topic = rest.Take<std::uint8_t>("a topic");
      const auto time_ns = rest.Take<std::int64_t>("a time");
      const auto size = std::min<std::size_t>(rest.Take<std::uint16_t>("a length"), rest.size());
      messages_.push_back({.topic = topic % contents_.topics.size(),
                           .time_ns = time_ns,
                           .data = rest.Bytes(size, "a message"),
                           .file = &kName,
                           .place = static_cast<std::int64_t>(messages_.size())});
      ++contents_.topics[messages_.back().topic].messages;
    }
  }

  const rosbag::BagContents& contents() const override { return contents_; }
  void Select(const std::vector<bool>& wanted) override {
    wanted_ = wanted;
    next_ = 0;
  }
  std::optional<rosbag::BagMessage> Next() override {
    while (next_ < messages_.size() && !wanted_[messages_[next_].topic]) ++next_;
    if (next_ == messages_.size()) return std::nullopt;
    return messages_[next_++];
  }

 private:
  static rosbag::BagTopic Topic(const char* name, const char* type, rosbag::Encoding encoding) {
    return {.name = name, .type = type, .encoding = encoding, .md5sum = ""};
  }

  rosbag::BagContents contents_{
      .format = kName,
      .topics = {Topic("/scan", "sensor_msgs/LaserScan", rosbag::Encoding::kCdr),
                 Topic("/scan", "sensor_msgs/LaserScan", rosbag::Encoding::kRos1),
                 Topic("/scan", "sensor_msgs/MultiEchoLaserScan", rosbag::Encoding::kCdr),
                 Topic("/odom", "nav_msgs/Odometry", rosbag::Encoding::kCdr),
                 Topic("/odom", "nav_msgs/Odometry", rosbag::Encoding::kRos1),
                 Topic("/tf", "tf2_msgs/TFMessage", rosbag::Encoding::kCdr),
                 Topic("/tf_static", "tf2_msgs/TFMessage", rosbag::Encoding::kRos1)}};
  std::vector<rosbag::BagMessage> messages_;
  std::vector<bool> wanted_;
  std::size_t next_ = 0;
};

}  // namespace
}  // namespace gmapping_spa::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  const std::string bytes = fuzz::TextOf(data, size);
  fuzz::ReadLog([&](const sensor::LogOptions& options) {
    auto records =
        std::make_unique<rosbag::BagReader>(std::make_unique<fuzz::Messages>(bytes), fuzz::kName,
                                            options, std::make_shared<rosbag::BagReport>());
    return sensor::ScansOf(std::move(records), fuzz::kName, options);
  });
  return 0;
}
