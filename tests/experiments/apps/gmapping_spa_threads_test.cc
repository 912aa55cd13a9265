// SPDX-License-Identifier: BSD-3-Clause
// What gmapping_spa does on several threads.
#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

TEST_F(GmappingSpaTour, ThreadsDoNotChangeTheResult) {
  Run(folder_.path(), {"--threads=2"});
  ExpectSameResult(Result(), folder_.path());
  EXPECT_EQ(ReadRunRecord(folder_.path())["resources"]["threads"], 2);
}

TEST_F(GmappingSpaTour, ResultsOfTheBackEndComeWhenTheFlagSays) {
  for (const std::string mode : {"async", "inline"}) {
    const std::string output_dir = folder_.Path(mode);
    Run(output_dir, {"--graph_thread=" + mode});
    EXPECT_LT(ErrorM(output_dir), 0.05) << mode;
    EXPECT_EQ(ReadRunRecord(output_dir)["flags"]["graph_thread"], mode);
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
