// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/live_source.h"

#include <utility>

namespace gmapping_spa::ros {

LiveSource::LiveSource(rosbag::Encoding encoding, std::size_t limit_bytes)
    : limit_bytes_(limit_bytes), current_() {
  contents_.format = "messages of a running robot";
  // In the order of Topic. That there are messages has to be told.
  contents_.topics = {{"scan", "sensor_msgs/LaserScan", encoding, "", 1},
                      {"tf", "tf2_msgs/TFMessage", encoding, "", 1}};
}

bool LiveSource::Give(Topic topic, std::string_view data, std::int64_t time_ns) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool fits = topic == kScan ? scan_bytes_ + data.size() <= limit_bytes_
                                     : tf_bytes_ + data.size() <= limit_bytes_;
    if (closed_ || !fits) return false;
    waiting_.push_back({topic, std::string(data), time_ns});
    (topic == kScan ? scan_bytes_ : tf_bytes_) += data.size();
    num_scans_ += topic == kScan ? 1 : 0;
  }
  changed_.notify_one();
  return true;
}

void LiveSource::Close(std::chrono::steady_clock::duration grace) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    end_ = std::chrono::steady_clock::now() + grace;
  }
  changed_.notify_one();
}

std::int64_t LiveSource::waiting_scans() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return num_scans_;
}

std::optional<rosbag::BagMessage> LiveSource::Next() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
  if (waiting_.empty()) return std::nullopt;
  if (closed_ && std::chrono::steady_clock::now() > end_) return std::nullopt;
  current_ = std::move(waiting_.front());
  waiting_.pop_front();
  (current_.topic == kScan ? scan_bytes_ : tf_bytes_) -= current_.data.size();
  num_scans_ -= current_.topic == kScan ? 1 : 0;
  return rosbag::BagMessage{current_.topic, current_.time_ns, current_.data,
                            &name_,         "message",        ++num_read_};
}

}  // namespace gmapping_spa::ros
