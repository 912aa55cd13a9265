// SPDX-License-Identifier: BSD-3-Clause
// Inputs that users of this field reported trouble with, where they are at hand. Equivalents of
// them are in the tests of the readers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/input_file.h"
#include "experiments/metrics/trajectory_error.h"
#include "frontend/map/map_server_io.h"
#include "tests/command_error.h"
#include "tests/real_data.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class SharedCases : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!RealDataPath("../cases/README.md")) GTEST_SKIP() << "the shared cases are not there";
  }
  static std::string Case(const std::string& name) {
    return RealDataPath("../cases/" + name).value_or(name);
  }
  static nlohmann::json Optimize(const std::string& name, const std::string& loss = "none") {
    const CommandResult result =
        RunCommand({OPTIMIZE_GRAPH, "--input=" + Case(name), "--backend=spa", "--loss=" + loss});
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }
  CommandResult Map(const std::string& name) const {
    return RunCommand({GMAPPING_SPA, "--log=" + Case(name), "--output_dir=" + folder_.Path("out")});
  }

  TemporaryFolder folder_;
};

TEST_F(SharedCases, GraphsWithAByteOrderMarkCommentsOrAnOffsetAreRead) {
  EXPECT_EQ(Optimize("bom.g2o")["termination"], "converged");
  EXPECT_EQ(Optimize("inline_comment.g2o")["termination"], "converged");
  EXPECT_NEAR(Optimize("params_se2offset.g2o")["final_cost"].get<double>(), 0.0476939, 1e-6);
}

TEST_F(SharedCases, DeletedIdsDoNotChangeWhichEdgesAreTheChain) {
  const nlohmann::json all = Optimize("small_ids_consecutive.g2o", "truncated");
  const nlohmann::json some = Optimize("small_ids_some_deleted.g2o", "truncated");
  EXPECT_EQ(all["final_cost"], some["final_cost"]);
}

TEST_F(SharedCases, LandmarksAreRefusedByName) {
  EXPECT_THAT(ErrorOf({OPTIMIZE_GRAPH, "--input=" + Case("landmark_xy.g2o")}),
              AllOf(HasSubstr(":5: "), HasSubstr("'VERTEX_XY': landmarks are not supported")));
}

TEST_F(SharedCases, AMapAsNav2WritesItIsRead) {
  EXPECT_GT(map::ReadMap(Case("negate_false.yaml")).width, 0);
}

TEST_F(SharedCases, TrajectoriesThatDoNotFitAreNamedWithTheirStamps) {
  const std::string truth = Case("odometry_reset.truth.tum");
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, "--truth=" + truth,
                       "--trajectory=" + Case("tum_nanoseconds.tum")}),
              AllOf(HasSubstr("odometry_reset.truth.tum has stamps from 1000.000 to "),
                    HasSubstr("tum_nanoseconds.tum has stamps from 100000000000.000 to ")));
  EXPECT_THAT(
      ErrorOf({EVALUATE_TRAJECTORY, "--truth=" + truth, "--trajectory=" + Case("tum_empty.tum")}),
      HasSubstr("tum_empty.tum: holds no poses"));
}

TEST_F(SharedCases, AByteOrderMarkCostsNoScan) {
  const CommandResult result = Map("carmen_bom.clf");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("3 scans"));
}

TEST_F(SharedCases, RangesInCentimetersAreAskedAbout) {
  EXPECT_THAT(ErrorOf({GMAPPING_SPA, "--log=" + Case("carmen_cm.clf"),
                       "--output_dir=" + folder_.Path("out")}),
              HasSubstr("are ranges in cm or mm"));
}

TEST_F(SharedCases, ALaserPoseThatAllRecordsAgreeOnIsUsed) {
  const CommandResult result = Map("carmen_flaser_offset_in_pose.clf");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("laser_pose_used: 127 "));
  const auto read = [](const std::string& path) {
    return backend::ReadTum(*OpenInput(path), path);
  };
  const auto pairs = metrics::AssociateByStamp(read(Case("carmen_flaser_offset_in_pose.truth.tum")),
                                               read(folder_.Path("out/trajectory.tum")), 0.01);
  EXPECT_EQ(pairs.size(), 127u);
  EXPECT_LT(metrics::AbsoluteTrajectoryError(pairs, metrics::Alignment::kSe2).translation_m.rmse,
            0.01);
}

}  // namespace
}  // namespace gmapping_spa::apps
