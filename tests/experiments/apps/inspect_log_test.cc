// SPDX-License-Identifier: BSD-3-Clause
// What inspect_log says and draws.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A robot that drives along x with 181 beams that end 2 m and more away; `odometry_m` says where
// the wheels see it at a step.
template <typename Odometry>
std::string Log(int scans, Odometry odometry_m, double unit_m = 1.0) {
  std::ostringstream log;
  for (int i = 0; i < scans; ++i) {
    log << "FLASER 181";
    for (int k = 0; k < 181; ++k) {
      log << ' ' << (2.0 + 0.05 * i + 0.01 * (k % 7) + (k % 10 == 0 ? 50.0 : 0.0)) / unit_m;
    }
    const double x = odometry_m(i);
    log << ' ' << x << " 0 0 " << x << " 0 0 " << 100.0 + 0.2 * i << " host 0\n";
  }
  return log.str();
}

std::string GoodLog() {
  return Log(50, [](int i) { return 30.0 + 0.05 * i; });
}

class InspectLog : public ::testing::Test {
 protected:
  CommandResult Run(const std::string& text, std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(), {INSPECT_LOG, "--log=" + folder_.FileWith("log.clf", text)});
    return RunCommand(flags);
  }
  nlohmann::json Report(const std::string& text, const std::vector<std::string>& flags = {}) {
    std::vector<std::string> all = {"--json"};
    all.insert(all.end(), flags.begin(), flags.end());
    const CommandResult result = Run(text, all);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }

  TemporaryFolder folder_;
};

TEST_F(InspectLog, ReportsScansTimesBeamsAndRanges) {
  const nlohmann::json report = Report("WHAT 1\n" + GoodLog());
  EXPECT_EQ(report["scans"], 50);
  EXPECT_EQ(report["records"]["unknown_records"], 1);
  EXPECT_NEAR(report["duration_s"].get<double>(), 9.8, 1e-6);
  EXPECT_NEAR(report["rate_hz"].get<double>(), 5.0, 1e-6);
  EXPECT_NEAR(report["longest_period_s"].get<double>(), 0.2, 1e-6);
  EXPECT_EQ(report["beam_counts"], nlohmann::json({{{"beams", 181}, {"scans", 50}}}));
  EXPECT_EQ(report["field_of_view"]["first_deg"], -90.0);
  EXPECT_EQ(report["field_of_view"]["last_deg"], 90.0);
  EXPECT_EQ(report["field_of_view"]["assumed"], true);
  EXPECT_NEAR(report["ranges"]["no_return_share"].get<double>(), 19.0 / 181.0, 1e-9);
  EXPECT_NEAR(report["ranges"]["shortest_hit_m"].get<double>(), 2.0, 0.02);
  EXPECT_EQ(report["laser_pose"]["from"], "the log, or by default");
  EXPECT_EQ(report["odometry"]["scans"], 50);
  EXPECT_NEAR(report["odometry"]["path_m"].get<double>(), 49 * 0.05, 1e-6);
  EXPECT_EQ(report["health"].size(), 2u) << report["health"];
  EXPECT_EQ(report["health"]["unknown_records"]["count"], 1);
  EXPECT_EQ(report["health"]["assumed_field_of_view"]["count"], 50);
}

TEST_F(InspectLog, FlagsOfTheLogHoldAsForGmappingSpa) {
  const nlohmann::json report =
      Report(GoodLog(), {"--fov_deg=90", "--usable_range_m=60", "--laser_pose=0.5,0,0"});
  EXPECT_EQ(report["field_of_view"]["last_deg"], 45.0);
  EXPECT_EQ(report["field_of_view"]["assumed"], false);
  EXPECT_EQ(report["ranges"]["hit_share"], 1.0);
  EXPECT_EQ(report["laser_pose"]["x_m"], 0.5);
  EXPECT_EQ(report["laser_pose"]["from"], "--laser_pose");
  EXPECT_THAT(report["advice"].dump(), HasSubstr("field of view below 180 deg"));
}

TEST_F(InspectLog, FaultsOfTheOdometryHaveTheKeysOfARunAndTheirTimes) {
  const std::string log = Log(50, [](int i) {
    return i < 20 ? 30.0 + 0.05 * i : i < 30 ? 80.0 + 0.05 * i : i < 40 ? 82.0 : 0.05 * (i - 40);
  });
  const nlohmann::json report = Report(log);
  const nlohmann::json& health = report["health"];
  EXPECT_EQ(health["odometry_impossible"]["count"], 1);
  EXPECT_NEAR(health["odometry_impossible"]["first_s"].get<double>(), 104.0, 1e-6);
  EXPECT_EQ(health["odometry_restart"]["count"], 1);
  ASSERT_EQ(health["odometry_silent"]["stretches"].size(), 1u);
  EXPECT_EQ(report["odometry"]["unchanged_steps"], 9);
  EXPECT_EQ(report["odometry"]["longest_steps"][0]["fault"], "odometry_restart");
  EXPECT_THAT(Run(log).out,
              AllOf(HasSubstr("  odometry_impossible: 1 times from 104.000 s to 104.000 s: the "),
                    HasSubstr("  assumed_field_of_view: 50 scans do not tell")));
}

TEST_F(InspectLog, OdometryThatNeverChangesIsSaidToBeSo) {
  EXPECT_THAT(Report(Log(50, [](int) { return 0.0; }))["advice"].dump(),
              HasSubstr("the odometry is the same throughout"));
}

TEST_F(InspectLog, ALogWhoseBeamsNeverHitIsDescribedNotRefused) {
  const nlohmann::json report = Report(Log(
      5, [](int i) { return 0.1 * i; }, 0.01));
  EXPECT_THAT(report["health"]["few_hits"].dump(), HasSubstr("cm or mm"));
}

TEST_F(InspectLog, TextSaysTheSame) {
  const CommandResult result = Run(GoodLog());
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("log.clf: 50 scans in 9.8 s"), HasSubstr("50 scans of 181 beams"),
                    HasSubstr("from -90.00 to 90.00 deg, assumed"), HasSubstr("#####"),
                    HasSubstr("Odometry: of 50 scans"), HasSubstr("Health, as run.json")));
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("inspect.png")));
}

TEST_F(InspectLog, DrawsOnePageTheSameEveryTime) {
  const auto picture = [&](const std::string& text) {
    EXPECT_EQ(Run(text, {"--output_dir=" + folder_.Path("out")}).status, 0);
    std::ifstream in(folder_.Path("out/inspect.png"), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string png = picture(GoodLog());
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_GT(png.size(), 5000u);
  EXPECT_EQ(picture(GoodLog()), png);
}

TEST_F(InspectLog, NamesInABagNeedNotBeText) {
  rosbag::SmallBag bag(folder_.Path("log.mcap"), "mcap");
  bag.Scan(rosbag::kSecond_ns, {.frame = "la\x1b\xffser"},
           "/sc\x1b\xff"
           "an");
  const std::string path = bag.Finish();
  const CommandResult text = RunCommand({INSPECT_LOG, "--log=" + path});
  EXPECT_THAT(text.out, AllOf(HasSubstr("/sc?"), Not(HasSubstr("\x1b"))));
  const CommandResult json = RunCommand({INSPECT_LOG, "--log=" + path, "--json"});
  EXPECT_EQ(nlohmann::json::parse(json.out)["bag"]["topics"][0]["name"], "/sc\x1b\ufffdan");
}

TEST_F(InspectLog, BadInputIsOneLine) {
  for (const CommandResult& result :
       {Run("nothing\n"), RunCommand({INSPECT_LOG}), RunCommand({INSPECT_LOG, "--log=/none"}),
        Run(GoodLog(), {"--fov_deg=x"}), Run(GoodLog(), {"--output_dir=/proc/x"})}) {
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
