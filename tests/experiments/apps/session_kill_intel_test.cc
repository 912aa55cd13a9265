// SPDX-License-Identifier: BSD-3-Clause
// Runs on a real log that are killed: label "long". As many as GMAPPING_SPA_KILLS says, else 4.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "backend/counter_random.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/killed_run.h"
#include "tests/real_data.h"

namespace gmapping_spa::apps {
namespace {

TEST(SessionOfIntel, GoesOnToTheSameBytesFromRandomMoments) {
  const auto log = RealDataPath("carmen/intel.clf.gz");
  if (!log) GTEST_SKIP() << "no real data";
  const TemporaryFolder folder;
  const std::string whole = folder.Path("whole"), out = folder.Path("out");
  const auto command = [&](const std::string& output_dir) {
    return std::vector<std::string>{GMAPPING_SPA, "--threads=2", "--log=" + *log,
                                    "--output_dir=" + output_dir};
  };
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(RunCommand(command(whole)).status, 0);
  const double whole_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  backend::CounterRandom random(1, 2, 3, 4);
  const char* const asked = std::getenv("GMAPPING_SPA_KILLS");
  const int runs = asked != nullptr ? std::atoi(asked) : 4;
  int kills = 0, resumed = 0;
  for (int times = 0; times < runs; ++times) {
    const std::string session = folder.Path("sessions/s" + std::to_string(times));
    kills +=
        IsKilledAfter(whole_s * random.Uniform(), Start(WithSession(command(out), session, 0.2)));
    const CommandResult result = RunCommand(WithSession(command(out), session, 0.2));
    ASSERT_EQ(result.status, 0) << result.err;
    ExpectSameResult(whole, out);
    resumed += ReadRunRecord(out)["resources"].count("resumed_after_scans") > 0 ? 1 : 0;
  }
  std::cout << kills << " killed, " << resumed << " gone on with\n";
  EXPECT_GE(2 * kills, runs);
  EXPECT_GE(2 * resumed, runs);
}

}  // namespace
}  // namespace gmapping_spa::apps
