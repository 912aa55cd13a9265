// SPDX-License-Identifier: BSD-3-Clause
// When gmapping_spa gives the same result, and when another one.
#include <gtest/gtest.h>

#include <string>

#include "tests/built_back_ends.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

TEST_F(GmappingSpaTour, SecondRunGivesTheSameBytes) {
  Run(folder_.path(), {});
  ExpectSameResult(Result(), folder_.path());
}

TEST_F(GmappingSpaTour, FlagFilesRunAndRepeat) {
  for (const std::string name : {"gmapping", "gmapping_plus", "paper", "paper_plus"}) {
    const std::string flag_file = "--flagfile=" FLAGS_FOLDER "/" + name + ".flags";
    const std::string once = folder_.Path(name), again = folder_.Path(name + "_again");
    Run(once, {flag_file, "--particles=3"});
    Run(again, {flag_file, "--particles=3", "--threads=2"});
    ExpectSameResult(once, again);
    EXPECT_LT(ErrorM(once), 0.1) << name;
  }
}

TEST_F(GmappingSpaTour, FlagsThatTheCommandLineOverridesAreRecorded) {
  Run(folder_.path(), {"--particles=2", "--flagfile=" FLAGS_FOLDER "/gmapping.flags"});
  const Json record = ReadRunRecord(folder_.path());
  EXPECT_EQ(record["flags"]["particles"], 2);
  EXPECT_EQ(record["flag_overrides"],
            Json({"--linear_update_m=0.5 (command line) wins over 1.0 of gmapping.flags",
                  "--particles=2 (command line) wins over 30 of gmapping.flags"}));
}

TEST_F(GmappingSpaTour, AnotherSeedGivesAnotherTrajectory) {
  Run(folder_.path(), {"--seed=2"});
  EXPECT_FALSE(Contents(Result("trajectory.tum")) == Contents(folder_.Path("trajectory.tum")));
}

TEST_F(GmappingSpaTour, GzippedLogGivesTheSameResult) {
  ASSERT_EQ(RunCommand({"cp", Log(), folder_.Path("log.clf")}).status, 0);
  ASSERT_EQ(RunCommand({"gzip", "-n", folder_.Path("log.clf")}).status, 0);
  const std::string output_dir = folder_.Path("out");
  const auto result = RunCommand(Command(output_dir, {"--log=" + folder_.Path("log.clf.gz")}));
  ASSERT_EQ(result.status, 0) << result.err;
  for (const std::string& name : kByteIdentical) {
    EXPECT_TRUE(Contents(Result(name)) == Contents(output_dir + "/" + name)) << name;
  }
  Json plain = ReadRunRecord(Result()), gzipped = ReadRunRecord(output_dir);
  EXPECT_NE(plain["input"]["sha256"], gzipped["input"]["sha256"]);
  EXPECT_GT(plain["input"]["bytes"], gzipped["input"]["bytes"]);
  for (Json* record : {&plain, &gzipped}) {
    record->erase("resources");
    (*record)["input"].erase("sha256");
    (*record)["input"].erase("bytes");
  }
  EXPECT_EQ(plain, gzipped);
}

TEST_F(GmappingSpaTour, TrajectoryIsFarNearerToTheTruthThanDeadReckoning) {
  // Without updates after the first scan, all poses come from the wheels.
  Run(folder_.path(), {"--odometry=wheel", "--nofinal_optimization", "--linear_update_m=1000",
                       "--angular_update_rad=1000"});
  constexpr double kBoundM = 0.05;
  EXPECT_LT(ErrorM(Result()), kBoundM);
  EXPECT_GT(ErrorM(folder_.path()), 3.0 * kBoundM);
}

TEST_F(GmappingSpaTour, ABackEndThatRunsOutOfTimeIsInTheHealthOfTheRun) {
  EXPECT_EQ(ReadRunRecord(Result())["health"].count("backend_not_converged"), 0u);
  Run(folder_.path(), {"--max_solver_time_s=1e-9"});
  const Json finding = ReadRunRecord(folder_.path())["health"]["backend_not_converged"];
  EXPECT_GE(finding["count"], 2);
  EXPECT_EQ(finding["message"], "the back end ended before it had converged: ran out of time");
}

TEST_F(GmappingSpaTour, APluginByItsPathIsTheSameBackEnd) {
  Run(folder_.path(), {std::string("--backend=") + PLUGIN});
  EXPECT_TRUE(Contents(Result("trajectory.tum")) == Contents(folder_.Path("trajectory.tum")));
}

class OtherBackEnd : public GmappingSpaTour, public ::testing::WithParamInterface<const char*> {};

TEST_P(OtherBackEnd, Runs) {
  const std::string backend = GetParam();
  Run(folder_.path(), {"--backend=" + backend});
  EXPECT_LT(ErrorM(folder_.path()), 0.08);
  const Json record = ReadRunRecord(folder_.path());
  EXPECT_EQ(record["flags"]["backend"], backend);
  EXPECT_EQ(record["graph_thread"]["failed"], 0);
  EXPECT_EQ(record["counts"]["corrections"] == 0, backend == "none");
}

INSTANTIATE_TEST_SUITE_P(GmappingSpa, OtherBackEnd, ::testing::ValuesIn(Built({"ceres", "none"})),
                         [](const auto& test) { return std::string(test.param); });

class Switch : public GmappingSpaTour, public ::testing::WithParamInterface<const char*> {};

TEST_P(Switch, ChangesTheResultAndLeavesItGood) {
  Run(folder_.path(), {GetParam()});
  EXPECT_LT(ErrorM(folder_.path()), 0.08);
  EXPECT_FALSE(Contents(Result("trajectory.tum")) == Contents(folder_.Path("trajectory.tum")));
}

INSTANTIATE_TEST_SUITE_P(
    GmappingSpa, Switch,
    ::testing::Values("--odometry=wheel", "--scan_matcher=hill_climbing", "--noloop_closure",
                      "--nofinal_optimization", "--refine=0", "--refine=2", "--correction=pose",
                      "--edge_information=hessian", "--edge_information=constant",
                      "--edge_measurement=particle", "--odometry=raw", "--match_start=draw",
                      "--motion_noise=scan", "--proposal=match", "--likelihood=nearest_hit"));

}  // namespace
}  // namespace gmapping_spa::apps
