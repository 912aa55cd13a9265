// SPDX-License-Identifier: BSD-3-Clause
// The compressions of chunks and messages.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_UNPACK_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_UNPACK_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gmapping_spa::rosbag {

enum class Packing : std::uint8_t { kNone, kBz2, kLz4, kZstd };

// By the names of ROS 1 bags ("none", "bz2", "lz4") and of MCAP ("", "lz4", "zstd").
std::optional<Packing> PackingNamed(std::string_view name);

// What a chunk may unpack to, at most. Recorders write chunks of about a MB, larger ones where a
// single message is; one that claims more is likelier an attack on the memory.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{256} << 20;

// What a bag may unpack to in all, when it takes `bytes` on the disk: far above what recorders get
// to, and far below what somebody made up to fill the memory or to last for ever.
inline std::uint64_t MostUnpackedBytes(std::int64_t bytes) {
  return (std::uint64_t{4} << 20) + 1000 * static_cast<std::uint64_t>(bytes);
}

// Unpacks `packed` to exactly `size` bytes, at most kMaxChunkBytes. Throws BagError, for `file` and
// `byte`, when it is damaged or has another size.
std::string Unpack(Packing packing, std::string_view packed, std::uint64_t size,
                   const std::string& file, std::int64_t byte);

std::uint32_t Crc32(std::string_view bytes);

// Whether these are the first bytes of what zstd made.
bool IsZstd(std::string_view bytes);
// The size that zstd wrote down, or nothing where it did not or is larger than kMaxChunkBytes.
std::optional<std::uint64_t> ZstdSize(std::string_view packed);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_UNPACK_H_
