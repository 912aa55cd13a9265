// SPDX-License-Identifier: BSD-3-Clause
// A run that is killed goes on to the bytes of one that is not.
#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

#include "backend/counter_random.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/killed_run.h"
#include "tests/experiments/apps/signal_command.h"

namespace gmapping_spa::apps {
namespace {

class KilledTour : public GmappingSpaTour {
 protected:
  // A run that takes seconds.
  std::vector<std::string> Slow(const std::string& output_dir) const {
    return Command(output_dir, {"--particles=10", "--linear_update_m=0.1"});
  }

  const std::string whole_ = folder_.Path("whole"), out_ = folder_.Path("out"),
                    session_ = folder_.Path("sessions/s");
};

TEST_F(KilledTour, GoesOnToTheSameBytesHoweverOftenItIsKilled) {
  ASSERT_EQ(RunCommand(Slow(whole_)).status, 0);
  backend::CounterRandom random(1, 2, 3, 4);
  int kills = 0;
  while (kills < 3 && IsKilledAfterASession(0.02 * random.Uniform(), session_,
                                            WithSession(Slow(out_), session_, 0.02))) {
    ++kills;
  }
  ASSERT_TRUE(std::filesystem::exists(session_));
  EXPECT_GE(kills, 1);
  const CommandResult result = RunCommand(WithSession(Slow(out_), session_, 0.02));
  ASSERT_EQ(result.status, 0) << result.err;
  ExpectSameResult(whole_, out_);
  EXPECT_GT(ReadRunRecord(out_)["resources"]["resumed_after_scans"], 0);
}

TEST_F(KilledTour, ToldToEndWritesItsSession) {
  ASSERT_EQ(RunCommand(Slow(whole_)).status, 0);
  const std::vector<std::string> command = WithSession(Slow(out_), session_, 0.0);
  EXPECT_EQ(SignalCommand(command, out_, SIGTERM).status, 128 + SIGTERM);
  ASSERT_TRUE(std::filesystem::exists(session_));
  const CommandResult result = RunCommand(WithSession(Slow(out_), session_, 0.0));
  ASSERT_EQ(result.status, 0) << result.err;
  ExpectSameResult(whole_, out_);
}

}  // namespace
}  // namespace gmapping_spa::apps
