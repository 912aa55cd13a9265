// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/message_fields.h"

#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::rosbag {

using sensor::MalformedRecord;

MessageFields::MessageFields(std::string_view data, Encoding encoding)
    : data_(data), encoding_(encoding) {
  if (is_ros1()) return;
  const std::string_view header = Bytes(4, 1, "a header of CDR");
  const bool is_plain = header[0] == 0 && (header[1] == 0 || header[1] == 1);
  if (!is_plain) throw MalformedRecord("expected plain CDR, found another encoding of the message");
  swaps_ = header[1] == 0;
  data_.remove_prefix(4);
  position_ = 0;
}

std::string_view MessageFields::Bytes(std::size_t count, std::size_t alignment, const char* what) {
  if (!is_ros1()) position_ = (position_ + alignment - 1) / alignment * alignment;
  const std::size_t left = position_ < data_.size() ? data_.size() - position_ : 0;
  if (count > left) {
    throw MalformedRecord("expected " + std::to_string(count) + " bytes of " + what + ", found " +
                          std::to_string(left) + " up to the end of the message");
  }
  const std::string_view bytes = data_.substr(position_, count);
  position_ += count;
  return bytes;
}

std::string MessageFields::Text(const char* what) {
  const auto size = Take<std::uint32_t>(what);
  std::string_view text = Bytes(size, 1, what);
  if (!is_ros1() && text.ends_with('\0')) text.remove_suffix(1);  // which the length counts
  return std::string(text);
}

std::size_t MessageFields::Count(std::size_t item_bytes, const char* what) {
  const std::size_t count = Take<std::uint32_t>(what);
  const std::size_t left = data_.size() - position_;
  if (count > left / item_bytes) {
    throw MalformedRecord("expected " + std::to_string(count) + " " + what + ", found " +
                          std::to_string(left) + " bytes up to the end of the message");
  }
  return count;
}

std::vector<double> MessageFields::Floats(const char* what) {
  std::vector<double> values(Count(sizeof(float), what));
  for (double& value : values) value = Take<float>(what);
  return values;
}

}  // namespace gmapping_spa::rosbag
