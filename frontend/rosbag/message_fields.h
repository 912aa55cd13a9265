// SPDX-License-Identifier: BSD-3-Clause
// The fields of a message, as ROS 1 and ROS 2 (CDR) serialize them.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_MESSAGE_FIELDS_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_MESSAGE_FIELDS_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

// ROS 1 packs little-endian fields without gaps. CDR (OMG DDSI-RTPS, 10.2) says its byte order in a
// header of four bytes, and aligns each number to its own size, counted from behind that header.
// Everything throws sensor::MalformedRecord where the message is too short for what is asked for.
class MessageFields {
 public:
  MessageFields(std::string_view data, Encoding encoding);

  bool is_ros1() const { return encoding_ == Encoding::kRos1; }

  template <typename Number>
  Number Take(const char* what) {
    std::array<char, sizeof(Number)> bytes;
    const std::string_view found = Bytes(sizeof(Number), sizeof(Number), what);
    std::copy(found.begin(), found.end(), bytes.begin());
    if (swaps_) std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), sizeof(Number));
    return number;
  }

  std::string Text(const char* what);

  // The length of a sequence whose items take `item_bytes` or more: refuses one that the rest of
  // the message cannot hold, before anybody makes room for it.
  std::size_t Count(std::size_t item_bytes, const char* what);

  // A sequence of float32.
  std::vector<double> Floats(const char* what);

 private:
  std::string_view Bytes(std::size_t count, std::size_t alignment, const char* what);

  std::string_view data_;  // without the header of CDR
  std::size_t position_ = 0;
  Encoding encoding_;
  bool swaps_ = false;  // the byte order
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_MESSAGE_FIELDS_H_
