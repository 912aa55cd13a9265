// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/open_source.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "frontend/rosbag/bag_folder.h"
#include "frontend/rosbag/byte_file.h"
#include "frontend/rosbag/mcap_file.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/rosbag/ros1_bag.h"
#include "frontend/rosbag/sqlite_bag.h"
#include "frontend/rosbag/unpack.h"

namespace gmapping_spa::rosbag {
namespace {

std::string FirstBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(kSqliteMagic.size(), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace

bool BeginsAsABag(std::string_view bytes) {
  return bytes.starts_with(kRos1Magic) || bytes.starts_with(kMcapMagic) ||
         bytes.starts_with(kSqliteMagic) || IsZstd(bytes);
}

bool IsBag(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return true;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  return BeginsAsABag(FirstBytes(path));
}

std::unique_ptr<MessageSource> OpenSource(const std::string& path) {
  if (std::filesystem::is_directory(path)) return OpenBagFolder(path);
  const std::string bytes = FirstBytes(path);
  if (bytes.starts_with(kRos1Magic)) return OpenRos1Bag(ByteFile(path));
  if (bytes.starts_with(kMcapMagic)) return OpenMcap(ByteFile(path));
  if (bytes.starts_with(kSqliteMagic)) return OpenSqliteBag(path);
  if (IsZstd(bytes)) {
    throw std::runtime_error(path +
                             ": expected a bag, found a file packed by zstd: unpack it first "
                             "(zstd -d)");
  }
  throw std::runtime_error(path + ": expected a ROS 1 bag, MCAP or db3 file, found another one");
}

}  // namespace gmapping_spa::rosbag
