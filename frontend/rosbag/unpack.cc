// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/unpack.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <boost/crc.hpp>
#include <memory>

#include "frontend/rosbag/byte_cursor.h"

namespace gmapping_spa::rosbag {
namespace {

// These return the size, or nothing for damaged input. The end of the buffer counts as damage.
std::optional<std::uint64_t> UnpackBz2(std::string_view packed, std::string* bytes) {
  auto size = static_cast<unsigned int>(bytes->size());
  // The library takes a pointer to what it does not write to.
  const int status =
      BZ2_bzBuffToBuffDecompress(bytes->data(), &size, const_cast<char*>(packed.data()),
                                 static_cast<unsigned int>(packed.size()), 0, 0);
  if (status != BZ_OK) return std::nullopt;
  return size;
}

std::optional<std::uint64_t> UnpackLz4(std::string_view packed, std::string* bytes) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) return std::nullopt;
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      made, &LZ4F_freeDecompressionContext);
  std::size_t written = 0;
  while (!packed.empty()) {
    std::size_t out = bytes->size() - written, in = packed.size();
    const std::size_t more =
        LZ4F_decompress(context.get(), bytes->data() + written, &out, packed.data(), &in, nullptr);
    if (LZ4F_isError(more) != 0) return std::nullopt;
    written += out;
    packed.remove_prefix(in);
    if (more == 0 && packed.empty()) return written;
    if (in == 0 && out == 0) return std::nullopt;  // no room, or no end
  }
  return std::nullopt;
}

std::optional<std::uint64_t> UnpackZstd(std::string_view packed, std::string* bytes) {
  const std::size_t size =
      ZSTD_decompress(bytes->data(), bytes->size(), packed.data(), packed.size());
  if (ZSTD_isError(size) != 0) return std::nullopt;
  return size;
}

}  // namespace

std::optional<Packing> PackingNamed(std::string_view name) {
  if (name.empty() || name == "none") return Packing::kNone;
  if (name == "bz2") return Packing::kBz2;
  if (name == "lz4") return Packing::kLz4;
  if (name == "zstd") return Packing::kZstd;
  return std::nullopt;
}

std::string Unpack(Packing packing, std::string_view packed, std::uint64_t size,
                   const std::string& file, std::int64_t byte) {
  if (size > kMaxChunkBytes) {
    throw BagError(file, byte,
                   "expected a chunk of at most " + std::to_string(kMaxChunkBytes) +
                       " bytes, found one that says it has " + std::to_string(size));
  }
  if (packing == Packing::kNone) {
    if (packed.size() == size) return std::string(packed);
    throw BagError(file, byte,
                   "expected a chunk of " + std::to_string(size) + " bytes, found " +
                       std::to_string(packed.size()));
  }
  std::string bytes(size, '\0');
  const std::optional<std::uint64_t> unpacked = packing == Packing::kBz2 ? UnpackBz2(packed, &bytes)
                                                : packing == Packing::kLz4
                                                    ? UnpackLz4(packed, &bytes)
                                                    : UnpackZstd(packed, &bytes);
  const std::string expected =
      "expected a chunk that unpacks to " + std::to_string(size) + " bytes";
  if (!unpacked) throw BagError(file, byte, expected + ", found a larger or a damaged one");
  if (*unpacked != size) {
    throw BagError(file, byte, expected + ", found " + std::to_string(*unpacked));
  }
  return bytes;
}

std::uint32_t Crc32(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

bool IsZstd(std::string_view bytes) { return bytes.starts_with("\x28\xb5\x2f\xfd"); }

std::optional<std::uint64_t> ZstdSize(std::string_view packed) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR || size > kMaxChunkBytes) {
    return std::nullopt;
  }
  return size;
}

}  // namespace gmapping_spa::rosbag
