// SPDX-License-Identifier: BSD-3-Clause
// Runs on a real log that are killed, twenty of them. Minutes: label "long".
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <string>
#include <vector>

#include "backend/counter_random.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/killed_run.h"
#include "tests/real_data.h"

namespace gmapping_spa::apps {
namespace {

TEST(SessionOfIntel, GoesOnToTheSameBytesFromTwentyRandomMoments) {
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
  int kills = 0, resumed = 0;
  for (int times = 0; times < 20; ++times) {
    const std::string session = folder.Path("sessions/s" + std::to_string(times));
    kills += IsKilledAfter(whole_s * random.Uniform(), WithSession(command(out), session, 0.2));
    const CommandResult result = RunCommand(WithSession(command(out), session, 0.2));
    ASSERT_EQ(result.status, 0) << result.err;
    ExpectSameResult(whole, out);
    resumed += ReadRunRecord(out)["resources"].count("resumed_after_scans") > 0 ? 1 : 0;
  }
  std::cout << kills << " killed, " << resumed << " gone on with\n";
  EXPECT_GE(kills, 10);
  EXPECT_GE(resumed, 10);
}

}  // namespace
}  // namespace gmapping_spa::apps
