// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/session/session_file.h"

#include <zstd.h>

#include <boost/crc.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/string.hpp>
#include <iterator>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

#include "frontend/session/archive.h"

namespace gmapping_spa::session {
namespace {

constexpr int kCompressionLevel = 1;  // a run waits for no more
// Maps are mostly empty cells, but not as empty as what somebody made up to fill the memory.
constexpr std::uint64_t kMostCompression = 1000;

struct Header {
  std::uint32_t version = kSessionVersion;
  std::uint32_t checksum = 0;  // CRC-32 of the sizes and of what follows
  std::uint64_t compressed_size = 0;
  std::uint64_t size = 0;
};
static_assert(sizeof(Header) == 24, "it is written as it is");

std::uint32_t Checksum(const Header& header, std::string_view compressed) {
  boost::crc_32_type crc;
  crc.process_bytes(&header.version, sizeof header.version);
  crc.process_bytes(&header.compressed_size, sizeof header.compressed_size);
  crc.process_bytes(&header.size, sizeof header.size);
  crc.process_bytes(compressed.data(), compressed.size());
  return crc.checksum();
}

// Of both, one after the other, without a copy of them.
std::string Compressed(std::string_view first, std::string_view second) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     &ZSTD_freeCCtx);
  if (context == nullptr) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kCompressionLevel);
  std::string compressed(ZSTD_compressBound(first.size() + second.size()), '\0');
  ZSTD_outBuffer out{compressed.data(), compressed.size(), 0};
  const auto feed = [&](std::string_view piece, ZSTD_EndDirective then) {
    ZSTD_inBuffer in{piece.data(), piece.size(), 0};
    for (std::size_t left = 1; left > 0 || in.pos < in.size;) {
      left = ZSTD_compressStream2(context.get(), &out, &in, then);
      if (ZSTD_isError(left)) throw std::runtime_error(ZSTD_getErrorName(left));
      if (then == ZSTD_e_continue && in.pos == in.size) break;
    }
  };
  feed(first, ZSTD_e_continue);
  feed(second, ZSTD_e_end);
  compressed.resize(out.pos);
  return compressed;
}

}  // namespace

void WriteSession(const Session& session, std::ostream* out) {
  SaveArchive archive;
  archive(session.info);
  const std::string info = archive.TakeBytes();
  const std::size_t size = info.size() + session.state.size();
  const std::string compressed = Compressed(info, session.state);
  Header header{.compressed_size = compressed.size(), .size = size};
  header.checksum = Checksum(header, compressed);
  *out << kMagic;
  out->write(reinterpret_cast<const char*>(&header), sizeof header);
  *out << compressed;
}

Session ReadSession(std::istream* in, const std::string& name) {
  const auto fail = [&](const std::string& expected, const std::string& found) {
    throw std::runtime_error(name + ": expected " + expected + ", found " + found);
  };
  const std::string file(std::istreambuf_iterator<char>(*in), {});
  if (!file.starts_with(kMagic)) fail("a session of gmapping_spa", "another file");
  Header header;
  if (file.size() < kMagic.size() + sizeof header) fail("a whole session", "one that is cut");
  file.copy(reinterpret_cast<char*>(&header), sizeof header, kMagic.size());
  if (header.version > kSessionVersion) {
    fail("a session of version " + std::to_string(kSessionVersion) + " or before",
         "version " + std::to_string(header.version) + " of a newer program");
  }
  const std::string_view compressed = std::string_view(file).substr(kMagic.size() + sizeof header);
  if (compressed.size() < header.compressed_size) fail("a whole session", "one that is cut");
  if (compressed.size() != header.compressed_size ||
      header.checksum != Checksum(header, compressed) ||
      header.size / kMostCompression > compressed.size()) {
    fail("a session as it was written", "one that is damaged");
  }
  std::string content(header.size, '\0');
  if (ZSTD_decompress(content.data(), content.size(), compressed.data(), compressed.size()) !=
      content.size()) {
    fail("a session as it was written", "one that is damaged");
  }
  Session session;
  LoadArchive archive(content);
  archive(session.info);
  session.state = content.substr(content.size() - archive.left());
  return session;
}

}  // namespace gmapping_spa::session
