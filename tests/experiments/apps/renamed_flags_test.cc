// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/renamed_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace gmapping_spa::apps {
namespace {

TEST(RefuseFormerName, TellsTheNewOneHoweverTheOldOneIsWritten) {
  for (const char* flag : {"final_round", "nofinal_round", "final_round=false"}) {
    EXPECT_THAT([flag] { RefuseFormerName("my.flags:3", flag); },
                testing::ThrowsMessage<std::runtime_error>(
                    "my.flags:3: --final_round is called --final_optimization now"));
  }
}

TEST(RefuseFormerName, LetsAllOtherFlagsPass) {
  for (const char* flag : {"", "final_optimization", "nothing", "no", "refine=2", "=final_round"}) {
    EXPECT_NO_THROW(RefuseFormerName("command line", flag)) << flag;
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
