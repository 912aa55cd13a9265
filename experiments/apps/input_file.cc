// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/input_file.h"

#include <openssl/evp.h>

#include <array>
#include <boost/iostreams/categories.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <boost/iostreams/read.hpp>
#include <boost/iostreams/stream.hpp>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "experiments/apps/staging_folder.h"

namespace gmapping_spa::apps {
namespace {

constexpr std::size_t kBufferBytes = 1 << 16;

// Throws unless `path` is a file that can be read.
std::ifstream OpenFile(const std::string& path) {
  CompleteSetOf(path);
  // A directory opens like a file, and fails only when it is read.
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw std::runtime_error(path + ": expected a file, found a directory");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::runtime_error(path +
                             ": cannot be opened: " + std::generic_category().message(errno));
  }
  return file;
}

// Looks at the first two bytes and puts them back; no seeking, so that pipes will do.
bool IsGzip(std::istream& file) {
  const int first = file.get();
  const int second = file.peek();
  if (first != EOF) file.unget();
  file.clear();
  return first == 0x1f && second == 0x8b;
}

// A file, unpacked where need be, whose errors tell its name.
class FileSource {
 public:
  using char_type = char;
  using category = boost::iostreams::source_tag;

  explicit FileSource(const std::string& path)
      : path_(path), file_(std::make_shared<std::ifstream>(OpenFile(path))) {
    if (IsGzip(*file_)) {
      unpacker_ = std::make_shared<boost::iostreams::filtering_istreambuf>();
      unpacker_->push(boost::iostreams::gzip_decompressor(), kBufferBytes);
      unpacker_->push(*file_, kBufferBytes);
    }
  }

  // Boost.Iostreams wants the number of characters, and -1 at the end.
  std::streamsize read(char* buffer, std::streamsize size) {
    if (!unpacker_) {
      file_->read(buffer, size);
      if (file_->bad()) throw std::runtime_error(path_ + ": cannot be read");
      return file_->gcount() > 0 ? file_->gcount() : -1;
    }
    try {
      return boost::iostreams::read(*unpacker_, buffer, size);
    } catch (const std::exception&) {
      throw std::runtime_error(path_ + ": truncated or corrupt gzip file");
    }
  }

 private:
  std::string path_;
  // Shared, because Boost.Iostreams copies its sources.
  std::shared_ptr<std::ifstream> file_;
  std::shared_ptr<boost::iostreams::filtering_istreambuf> unpacker_;  // none for a plain file
};

}  // namespace

std::unique_ptr<std::istream> OpenInput(const std::string& path) {
  auto stream = std::make_unique<boost::iostreams::stream<FileSource>>(FileSource(path));
  // Otherwise the stream would swallow the exceptions of its source.
  stream->exceptions(std::ios::badbit);
  return stream;
}

FileIdentity IdentifyFile(const std::string& path) {
  std::ifstream file = OpenFile(path);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        &EVP_MD_CTX_free);
  bool ok = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  FileIdentity identity;
  std::vector<char> buffer(kBufferBytes);
  while (ok && file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    if (file.bad()) throw std::runtime_error(path + ": cannot be read");
    identity.bytes += file.gcount();
    ok = EVP_DigestUpdate(context.get(), buffer.data(), static_cast<std::size_t>(file.gcount())) ==
         1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int digest_size = 0;
  ok = ok && EVP_DigestFinal_ex(context.get(), digest.data(), &digest_size) == 1;
  if (!ok) throw std::runtime_error(path + ": its SHA-256 cannot be computed");
  for (unsigned int i = 0; i < digest_size; ++i) {
    constexpr char kHex[] = "0123456789abcdef";
    identity.sha256 += kHex[digest[i] >> 4];
    identity.sha256 += kHex[digest[i] & 15];
  }
  return identity;
}

}  // namespace gmapping_spa::apps
