// SPDX-License-Identifier: BSD-3-Clause
// Opening input files, plain or gzipped.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_INPUT_FILE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_INPUT_FILE_H_

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

namespace gmapping_spa::apps {

// Opens `path` for reading, unpacking it on the way when its first bytes are those of gzip (of
// several members too). Throws std::runtime_error with one line when it is missing, a directory or
// unreadable. Reading from the stream (its exceptions are on for badbit) throws the like when the
// file turns out truncated or corrupt, so that readers never take a broken file for a short one.
std::unique_ptr<std::istream> OpenInput(const std::string& path);

// SHA-256 of the bytes of the file (as `sha256sum` prints it) and its size.
struct FileIdentity {
  std::string sha256;
  std::int64_t bytes = 0;
};
FileIdentity IdentifyFile(const std::string& path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_INPUT_FILE_H_
