// SPDX-License-Identifier: BSD-3-Clause
// The messages of a running robot, as if they were those of a bag.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_LIVE_SOURCE_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_LIVE_SOURCE_H_

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::ros {

// A queue between threads that give messages, which never wait, and one that reads them.
class LiveSource : public rosbag::MessageSource {
 public:
  enum Topic : std::uint8_t { kScan, kTf };

  // A scan is refused that would make those that wait more than `limit_bytes`, and likewise
  // transforms among themselves.
  LiveSource(rosbag::Encoding encoding, std::size_t limit_bytes);

  // Whether there was room. Of any thread.
  bool Give(Topic topic, std::string_view data, std::int64_t time_ns);

  // No more messages come. Those that wait are read for so long, and then left.
  void Close(std::chrono::steady_clock::duration grace);

  // Scans that wait; after the end, those that were left.
  std::int64_t waiting_scans() const;

  const rosbag::BagContents& contents() const override { return contents_; }
  void Select(const std::vector<bool>&) override {}
  // Waits for the next message; nothing once the source is closed.
  std::optional<rosbag::BagMessage> Next() override;

 private:
  struct Held {
    Topic topic;
    std::string data;
    std::int64_t time_ns;
  };

  const std::size_t limit_bytes_;
  const std::string name_ = "live";  // for messages
  rosbag::BagContents contents_;
  Held current_;  // that the last message of Next shows

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Held> waiting_;
  std::size_t scan_bytes_ = 0, tf_bytes_ = 0;
  std::int64_t num_scans_ = 0;  // of waiting_
  std::int64_t num_read_ = 0;
  bool closed_ = false;
  std::chrono::steady_clock::time_point end_;
};

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_LIVE_SOURCE_H_
