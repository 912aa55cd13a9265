// SPDX-License-Identifier: BSD-3-Clause
// The fields of a record of a bag, taken one after the other. Containers are little-endian.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_BYTE_CURSOR_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_BYTE_CURSOR_H_

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "backend/text.h"

namespace gmapping_spa::rosbag {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

// "<file>: byte <offset>: <message>"
struct BagError : std::runtime_error {
  BagError(std::string_view file, std::int64_t byte, const std::string& message)
      : std::runtime_error(std::string(file) + ": byte " + std::to_string(byte) + ": " +
                           backend::Printable(message)) {}
};

class ByteCursor {
 public:
  // `bytes` stand at `byte` of the file, which must outlive the cursor; where they were unpacked
  // from a chunk, at `in_chunk` of it, and `byte` is that of the chunk.
  ByteCursor(std::string_view bytes, const std::string& file, std::int64_t byte,
             std::int64_t in_chunk = -1)
      : rest_(bytes), file_(&file), byte_(byte), in_chunk_(in_chunk) {}

  bool empty() const { return rest_.empty(); }
  std::size_t size() const { return rest_.size(); }

  template <typename Number>
  Number Take(const char* what) {
    Number number;
    std::memcpy(&number, Bytes(sizeof(Number), what).data(), sizeof(Number));
    return number;
  }

  std::string_view Bytes(std::uint64_t count, const char* what) {
    if (count > rest_.size()) {
      Fail("expected " + std::to_string(count) + " bytes of " + what + ", found " +
           std::to_string(rest_.size()));
    }
    const std::string_view bytes = rest_.substr(0, count);
    rest_.remove_prefix(count);
    (in_chunk_ < 0 ? byte_ : in_chunk_) += static_cast<std::int64_t>(count);
    return bytes;
  }

  // Bytes behind their number, of 32 bits.
  std::string_view Prefixed(const char* what) { return Bytes(Take<std::uint32_t>(what), what); }

  // Likewise, as a cursor of their own.
  ByteCursor PrefixedCursor(const char* what) {
    const auto count = Take<std::uint32_t>(what);
    return Part(count, what);
  }
  ByteCursor Part(std::uint64_t count, const char* what) {
    ByteCursor part = *this;
    part.rest_ = Bytes(count, what);
    return part;
  }

  [[noreturn]] void Fail(const std::string& message) const {
    const std::string place =
        in_chunk_ < 0 ? "" : "in this chunk, byte " + std::to_string(in_chunk_) + ": ";
    throw BagError(*file_, byte_, place + message);
  }

 private:
  std::string_view rest_;
  const std::string* file_;
  std::int64_t byte_;
  std::int64_t in_chunk_;
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_BYTE_CURSOR_H_
