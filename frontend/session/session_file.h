// SPDX-License-Identifier: BSD-3-Clause
// Sessions: runs that are written in the middle, to go on with later.
#ifndef GMAPPING_SPA_FRONTEND_SESSION_SESSION_FILE_H_
#define GMAPPING_SPA_FRONTEND_SESSION_SESSION_FILE_H_

#include <cstdint>
#include <istream>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

namespace gmapping_spa::session {

// Raised with every change of what SaveState writes. Those of before are read as long as
// ReadSession says so.
inline constexpr std::uint32_t kSessionVersion = 1;

// What a file begins with.
inline constexpr std::string_view kMagic = "gmapping_spa session\n";

struct SessionInfo {
  std::string program;                       // its version
  std::string log;                           // name of what the scans came from
  std::int64_t scans = 0;                    // taken so far
  double processing_s = 0.0;                 // wall time so far
  std::map<std::string, std::string> flags;  // that results depend on, and their values

  template <typename Archive>
  void serialize(Archive& archive) {
    archive(program, log, scans, processing_s, flags);
  }
};

struct Session {
  SessionInfo info;
  std::string state;  // SaveState, for LoadState (state.h)
};

// A header with the version, the sizes and a checksum, then all of it compressed.
void WriteSession(const Session& session, std::ostream* out);

// Throws std::runtime_error "<name>: expected <what>, found <what>" when it is no session, is cut
// or damaged, or was written by a newer version. Asks for no more memory than what was written
// needs, and looks at nothing before the checksum is right.
Session ReadSession(std::istream* in, const std::string& name);

}  // namespace gmapping_spa::session

#endif  // GMAPPING_SPA_FRONTEND_SESSION_SESSION_FILE_H_
