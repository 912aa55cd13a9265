// SPDX-License-Identifier: BSD-3-Clause
// gmapping_spa with its default flags on small logs that once went wrong: odometry without error
// that a front end must not spoil, and odometry that says nothing or restarts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/input_file.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/trajectory_error.h"
#include "tests/real_data.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;

// The folder lies beside that of the real data.
std::string CaseFile(const std::string& file) {
  return RealDataPath("../cases/" + file).value_or("");
}

class SlamCases : public ::testing::Test {
 protected:
  void SetUp() override {
    if (CaseFile("README.md").empty()) GTEST_SKIP() << "no cases";
  }

  // The root mean square of the position errors after alignment, in metres; warnings in warnings_.
  double ErrorM(const std::string& name) {
    const std::string truth = CaseFile(name + ".truth.tum");
    const CommandResult result = RunCommand({GMAPPING_SPA, "--log=" + CaseFile(name + ".clf"),
                                             "--seed=1", "--output_dir=" + folder_.path()});
    EXPECT_EQ(result.status, 0) << result.err;
    if (result.status != 0) return 1e9;
    warnings_ = result.err;
    const std::string found = folder_.Path("trajectory.tum");
    const double error_m =
        metrics::AbsoluteTrajectoryError(
            metrics::AssociateByStamp(backend::ReadTum(*OpenInput(truth), truth),
                                      backend::ReadTum(*OpenInput(found), found), 0.01),
            metrics::Alignment::kSe2)
            .translation_m.rmse;
    std::cout << name << ": " << error_m << " m\n";
    return error_m;
  }

  TemporaryFolder folder_;
  std::string warnings_;
};

TEST_F(SlamCases, ACorridorDrivenInReverseKeepsItsLength) {
  EXPECT_LE(ErrorM("reverse_corridor"), 0.01);
}

TEST_F(SlamCases, TwentyFourBeamsDoNotSpoilTheOdometry) {
  EXPECT_LE(ErrorM("sparse_24_beams"), 0.02);
}

TEST_F(SlamCases, ScansStandInForOdometryThatIsAlwaysZero) {
  EXPECT_LE(ErrorM("zero_odometry"), 0.012);
  EXPECT_THAT(warnings_, HasSubstr("the odometry stands still while the scans show motion"));
}

TEST_F(SlamCases, EncodersThatRestartAreNoticed) {
  EXPECT_LE(ErrorM("odometry_reset"), 0.01);
  EXPECT_THAT(warnings_, HasSubstr("encoders that restart"));
  EXPECT_THAT(warnings_, HasSubstr("s: the odometry jumps back"));
}

}  // namespace
}  // namespace gmapping_spa::apps
