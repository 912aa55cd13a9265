// SPDX-License-Identifier: BSD-3-Clause
// Values as bytes, for another process of the same build or one that comes later.
#ifndef GMAPPING_SPA_BACKEND_PACKET_H_
#define GMAPPING_SPA_BACKEND_PACKET_H_

#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace gmapping_spa::backend {

// What comes from the other process is not what was agreed on.
struct MalformedPacket : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class PacketWriter {
 public:
  template <typename Value>
  void Put(const Value& value) {
    PutBytes(&value, sizeof(Value));
    static_assert(std::is_trivially_destructible_v<Value> && !std::is_pointer_v<Value>);
  }
  void Put(const std::string& text) {
    Put(text.size());
    PutBytes(text.data(), text.size());
  }
  // Without their number.
  template <typename Value>
  void PutAll(std::span<Value> values) {
    PutBytes(values.data(), values.size_bytes());
    static_assert(std::is_trivially_destructible_v<Value>);
  }

  const std::vector<char>& bytes() const { return bytes_; }

 private:
  void PutBytes(const void* data, std::size_t size) {
    const char* const begin = static_cast<const char*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  std::vector<char> bytes_;
};

// Takes values in the order in which they were put. Throws MalformedPacket where there are not as
// many bytes: the other process may be out of its mind.
class PacketReader {
 public:
  explicit PacketReader(std::span<const char> bytes) : rest_(bytes) {}

  template <typename Value>
  Value Take() {
    Value value;
    TakeBytes(&value, sizeof(Value));
    return value;
  }
  std::string TakeText() {
    const auto size = Take<std::size_t>();
    CheckRoom(size, 1);
    std::string text(size, '\0');
    TakeBytes(text.data(), size);
    return text;
  }
  template <typename Value>
  void TakeAll(std::span<Value> values) {
    TakeBytes(values.data(), values.size_bytes());
  }
  // Throws when fewer than `count` values of that size are left: before memory is asked for.
  void CheckRoom(std::size_t count, std::size_t size) const {
    if (count > rest_.size() / size) throw MalformedPacket("a packet ends too early");
  }
  void CheckEnd() const {
    if (!rest_.empty()) throw MalformedPacket("a packet is too long");
  }

 private:
  void TakeBytes(void* data, std::size_t size) {
    CheckRoom(size, 1);
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const char> rest_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PACKET_H_
