// SPDX-License-Identifier: BSD-3-Clause
// Messages as bytes, in the serialization of ROS 1 or of ROS 2 (CDR, little-endian): the opposite
// of rosbag::MessageFields.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_MESSAGE_BYTES_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_MESSAGE_BYTES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::conversion {

// Little-endian, as all containers of bags are.
template <typename Number>
void AppendNumber(Number number, std::string* bytes) {
  const auto* first = reinterpret_cast<const char*>(&number);
  bytes->append(first, sizeof(Number));
}

// Text behind its length of 32 bits.
inline void AppendPrefixed(std::string_view text, std::string* bytes) {
  AppendNumber(static_cast<std::uint32_t>(text.size()), bytes);
  bytes->append(text);
}

class MessageBytes {
 public:
  explicit MessageBytes(rosbag::Encoding encoding) : is_ros1_(encoding == rosbag::Encoding::kRos1) {
    if (!is_ros1_) bytes_.assign({0, 1, 0, 0});
  }

  bool is_ros1() const { return is_ros1_; }

  template <typename Number>
  MessageBytes& Put(Number number) {
    constexpr std::size_t kHeaderBytes = 4;
    if (!is_ros1_) {
      while ((bytes_.size() - kHeaderBytes) % sizeof(Number) != 0) bytes_ += '\0';
    }
    AppendNumber(number, &bytes_);
    return *this;
  }
  MessageBytes& Text(std::string_view text) {
    Put(static_cast<std::uint32_t>(text.size() + (is_ros1_ ? 0 : 1)));
    bytes_ += text;
    if (!is_ros1_) bytes_ += '\0';
    return *this;
  }
  MessageBytes& Header(std::int64_t stamp_ns, std::string_view frame_id) {
    if (is_ros1_) Put(std::uint32_t{0});  // a sequence number
    Put(static_cast<std::uint32_t>(stamp_ns / 1000000000));
    Put(static_cast<std::uint32_t>(stamp_ns % 1000000000));
    return Text(frame_id);
  }
  MessageBytes& Floats(const std::vector<float>& values) {
    Put(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) Put(value);
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  bool is_ros1_;
  std::string bytes_;
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_MESSAGE_BYTES_H_
