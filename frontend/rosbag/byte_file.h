// SPDX-License-Identifier: BSD-3-Clause
// A file that is read piece by piece, from any place.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_BYTE_FILE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_BYTE_FILE_H_

#include <cstdint>
#include <memory>
#include <string>

namespace gmapping_spa::rosbag {

class ByteFile {
 public:
  // Throws std::runtime_error with one line when the file cannot be opened.
  explicit ByteFile(const std::string& path);

  const std::string& path() const { return path_; }
  std::int64_t size() const { return size_; }

  // The bytes [offset, offset + count). Throws BagError, with `what` for what was expected there,
  // when the file does not hold them all: before it allocates anything.
  std::string Read(std::int64_t offset, std::uint64_t count, const char* what) const;
  // Likewise as many of them as there are.
  std::string ReadUpTo(std::int64_t offset, std::int64_t count) const;

 private:
  std::string path_;
  std::shared_ptr<const int> descriptor_;
  std::int64_t size_ = 0;
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_BYTE_FILE_H_
