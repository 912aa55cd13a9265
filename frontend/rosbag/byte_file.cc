// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/byte_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "frontend/rosbag/byte_cursor.h"

namespace gmapping_spa::rosbag {

ByteFile::ByteFile(const std::string& path) : path_(path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    throw std::runtime_error(path +
                             ": cannot be opened: " + std::generic_category().message(errno));
  }
  descriptor_ = std::shared_ptr<const int>(new int(descriptor), [](const int* opened) {
    close(*opened);
    delete opened;
  });
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    throw std::runtime_error(path + ": expected a regular file");
  }
  size_ = status.st_size;
}

std::string ByteFile::Read(std::int64_t offset, std::uint64_t count, const char* what) const {
  const std::uint64_t left = offset >= 0 && offset <= size_ ? size_ - offset : 0;
  if (offset < 0 || count > left) {
    throw BagError(path_, offset,
                   "expected " + std::to_string(count) + " bytes of " + what + ", found " +
                       std::to_string(left) + " up to the end of the file");
  }
  return ReadUpTo(offset, static_cast<std::int64_t>(count));
}

std::string ByteFile::ReadUpTo(std::int64_t offset, std::int64_t count) const {
  std::string bytes(static_cast<std::size_t>(std::clamp<std::int64_t>(size_ - offset, 0, count)),
                    '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = pread(*descriptor_, bytes.data() + done, bytes.size() - done,
                              offset + static_cast<std::int64_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      throw BagError(path_, offset + static_cast<std::int64_t>(done),
                     "expected more of the file, found a read error");
    }
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace gmapping_spa::rosbag
