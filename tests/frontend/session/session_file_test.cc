// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/session/session_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>

#include "backend/counter_random.h"
#include "tests/message_of.h"

namespace gmapping_spa::session {
namespace {

using ::testing::AnyOf;
using ::testing::StartsWith;

Session SmallSession() {
  Session session;
  session.info = {.program = "1.2.3",
                  .log = "log.clf",
                  .scans = 17,
                  .processing_s = 2.5,
                  .flags = {{"particles", "3"}, {"seed", "1"}}};
  session.state = std::string(5000, 'a') + "and" + std::string(3000, '\0');
  return session;
}

std::string FileOf(const Session& session) {
  std::ostringstream out;
  WriteSession(session, &out);
  return out.str();
}

Session Read(const std::string& file) {
  std::istringstream in(file);
  return ReadSession(&in, "s");
}

TEST(SessionFile, IsReadAsItWasWritten) {
  const Session written = SmallSession(), read = Read(FileOf(written));
  EXPECT_EQ(read.info.program, written.info.program);
  EXPECT_EQ(read.info.log, written.info.log);
  EXPECT_EQ(read.info.scans, written.info.scans);
  EXPECT_EQ(read.info.processing_s, written.info.processing_s);
  EXPECT_EQ(read.info.flags, written.info.flags);
  EXPECT_EQ(read.state, written.state);
}

TEST(SessionFile, CutAnywhereIsRefused) {
  const std::string file = FileOf(SmallSession());
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_THAT(MessageOf([&] { Read(file.substr(0, size)); }),
                AnyOf("s: expected a whole session, found one that is cut",
                      "s: expected a session of gmapping_spa, found another file"));
  }
  EXPECT_EQ(MessageOf([&] { Read(file + '\n'); }),
            "s: expected a session as it was written, found one that is damaged");
}

TEST(SessionFile, DamagedInAnyBitIsRefused) {
  const std::string file = FileOf(SmallSession());
  for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
    std::string damaged = file;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    EXPECT_THAT(MessageOf([&] { Read(damaged); }), StartsWith("s: expected a")) << bit;
  }
}

TEST(SessionFile, OfANewerProgramIsRefusedAsSuch) {
  std::string file = FileOf(SmallSession());
  file[file.find('\n') + 1] = kSessionVersion + 1;
  EXPECT_EQ(MessageOf([&] { Read(file); }),
            "s: expected a session of version 1 or before, found version 2 of a newer program");
}

TEST(SessionFile, AnotherFileIsRefused) {
  EXPECT_EQ(MessageOf([] { Read("FLASER 3 1 1 1 0 0 0 0 0 0 0 h 0\n"); }),
            "s: expected a session of gmapping_spa, found another file");
}

}  // namespace
}  // namespace gmapping_spa::session
