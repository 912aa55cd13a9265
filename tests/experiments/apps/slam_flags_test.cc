// SPDX-License-Identifier: BSD-3-Clause
// What flags run is what the library runs, which has the same defaults and named settings.
#include "experiments/apps/slam_flags.h"

#include <gflags/gflags.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace gmapping_spa::apps {
namespace {

class SlamFlags : public testing::Test {
 protected:
  static SlamOptions OptionsOfFile(const std::string& name) {
    EXPECT_TRUE(gflags::ReadFromFlagsFile(FLAGS_FOLDER "/" + name, "slam_flags_test", false));
    return SlamOptionsFromFlags();
  }

 private:
  gflags::FlagSaver saver_;
};

TEST_F(SlamFlags, AnEmptyCommandLineRunsTheDefaultsOfTheLibrary) {
  EXPECT_EQ(SlamOptionsFromFlags(), SlamOptions{});
}

TEST_F(SlamFlags, PlainGmappingIsItsFlagFile) {
  EXPECT_EQ(OptionsOfFile("gmapping.flags"), SlamOptions::PlainGmapping());
}

TEST_F(SlamFlags, ThePaperIsItsFlagFile) {
  EXPECT_EQ(OptionsOfFile("paper.flags"), SlamOptions::Paper());
}

TEST_F(SlamFlags, AFlagChangesItsMemberOnly) {
  gflags::SetCommandLineOption("particles", "7");
  gflags::SetCommandLineOption("sweep_duration_s", "0.1");
  gflags::SetCommandLineOption("loss_scale", "2");
  SlamOptions expected;
  expected.particles = 7;
  expected.sweep_duration_s = 0.1;
  expected.optimizer.loss.scale = 2.0;
  EXPECT_EQ(SlamOptionsFromFlags(), expected);
}

TEST_F(SlamFlags, ABadValueIsToldWithItsFlag) {
  gflags::SetCommandLineOption("particles", "0");
  try {
    SlamOptionsFromFlags();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "--particles: expected a value from 1 to 100000, found 0");
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
