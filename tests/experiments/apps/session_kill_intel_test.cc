// SPDX-License-Identifier: BSD-3-Clause
// A run on a real log that is killed twenty times. Minutes: label "long".
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "backend/counter_random.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/killed_run.h"
#include "tests/real_data.h"

namespace gmapping_spa::apps {
namespace {

TEST(SessionOfIntel, GoesOnToTheSameBytesThoughKilledAtTwentyRandomMoments) {
  const auto log = RealDataPath("carmen/intel.clf.gz");
  if (!log) GTEST_SKIP() << "no real data";
  const TemporaryFolder folder;
  const std::string whole = folder.Path("whole"), out = folder.Path("out"),
                    session = folder.Path("sessions/s");
  const auto command = [&](const std::string& output_dir) -> std::vector<std::string> {
    return {GMAPPING_SPA, "--threads=2", "--log=" + *log, "--output_dir=" + output_dir};
  };
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(RunCommand(command(whole)).status, 0);
  const double whole_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  backend::CounterRandom random(1, 2, 3, 4);
  for (int kills = 0; kills < 20;) {
    const double life_s = 2.0 * whole_s / 20 * random.Uniform();
    if (IsKilledAfter(life_s, WithSession(command(out), session, 0.5))) {
      ++kills;
    } else {
      std::filesystem::remove(session);  // it had ended: from the begin
    }
  }
  const CommandResult result = RunCommand(WithSession(command(out), session, 0.5));
  ASSERT_EQ(result.status, 0) << result.err;
  ExpectSameResult(whole, out);
}

}  // namespace
}  // namespace gmapping_spa::apps
