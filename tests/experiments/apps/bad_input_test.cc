// SPDX-License-Identifier: BSD-3-Clause
// What gmapping_spa and simulate do about bad input: one clear line, and nothing half written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;

// A robot that stands in the middle of a round room.
std::string Scan(const std::string& stamp, const std::string& pose = "0 0 0",
                 const std::string& first_range = "5", const std::string& count = "180") {
  std::string line = "FLASER " + count + " " + first_range;
  for (int i = 1; i < 180; ++i) line += " 5";
  return line + " " + pose + " " + pose + " " + stamp + " host " + stamp + "\n";
}

std::string WithGoodScans(const std::string& line) {
  return Scan("1") + Scan("2") + line + Scan("3") + Scan("4");
}

class BadInput : public ::testing::Test {
 protected:
  CommandResult Run(const std::string& program, const std::vector<std::string>& flags) {
    std::vector<std::string> words = {program, "--output_dir=" + output_dir_};
    words.insert(words.end(), flags.begin(), flags.end());  // the last one of equal flags counts
    return RunCommand(words);
  }
  std::vector<std::string> LogFlags(const std::string& log) const {
    return {"--particles=2", "--log=" + log};
  }
  void ExpectOneLine(const CommandResult& result, const std::string& named) {
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr(named));
    EXPECT_FALSE(std::filesystem::exists(output_dir_));
  }

  TemporaryFolder folder_;
  std::string output_dir_ = folder_.Path("out");
  std::string good_log_ = folder_.FileWith("good.clf", WithGoodScans(""));
};

struct Case {
  std::string name;
  std::string value;  // a record, or a flag
  std::string named;  // in the message
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
std::string NameOf(const ::testing::TestParamInfo<Case>& info) { return info.param.name; }

class BadFile : public BadInput, public ::testing::WithParamInterface<Case> {};

TEST_P(BadFile, IsOneLine) {
  const std::string log = folder_.FileWith("bad.clf", GetParam().value);
  const CommandResult result = Run(GMAPPING_SPA, LogFlags(log));
  ExpectOneLine(result, log);
  EXPECT_THAT(result.err, HasSubstr(GetParam().named));
}

INSTANTIATE_TEST_SUITE_P(
    GmappingSpa, BadFile,
    ::testing::Values(Case{"Empty", "", "no laser scans"},
                      Case{"NoScans", "# comment\nODOM 0 0 0 0 0 0 1 h 1\n", "no laser scans"},
                      Case{"Garbage", "\x01\xff\xfe garbage \x7f\n\x80\x81", "no laser scans"},
                      Case{"TruncatedGzip", "\x1f\x8b\x08", "gzip"}),
    NameOf);

class BadRecord : public BadInput, public ::testing::WithParamInterface<Case> {};

TEST_P(BadRecord, AloneIsOneLine) {
  const std::string log = folder_.FileWith("bad.clf", GetParam().value + GetParam().value);
  ExpectOneLine(Run(GMAPPING_SPA, LogFlags(log)), log + ":1: expected ");
}

TEST_P(BadRecord, FailNamesTheLine) {
  const std::string log = folder_.FileWith("bad.clf", WithGoodScans(GetParam().value));
  std::vector<std::string> flags = LogFlags(log);
  flags.push_back("--bad_record=fail");
  ExpectOneLine(Run(GMAPPING_SPA, flags), log + ":3: expected ");
}

TEST_P(BadRecord, SkipGivesAResultFromTheGoodScans) {
  const std::string log = folder_.FileWith("bad.clf", WithGoodScans(GetParam().value));
  const CommandResult result = Run(GMAPPING_SPA, LogFlags(log));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("4 scans"));
  EXPECT_TRUE(std::filesystem::exists(output_dir_ + "/run.json"));
}

INSTANTIATE_TEST_SUITE_P(
    GmappingSpa, BadRecord,
    ::testing::Values(Case{"NegativeBeamCount", Scan("2.5", "0 0 0", "5", "-1"), ""},
                      Case{"HugeBeamCount", Scan("2.5", "0 0 0", "5", "1000000000"), ""},
                      Case{"NoBeams", "FLASER 0 0 0 0 0 0 0 2.5 host 2.5\n", ""},
                      Case{"NanPose", Scan("2.5", "0 nan 0"), ""},
                      Case{"InfinitePose", Scan("2.5", "0 inf 0"), ""},
                      Case{"HugePose", Scan("2.5", "1e300 0 0"), ""},
                      Case{"HugeHeading", Scan("2.5", "0 0 1e300"), ""},
                      Case{"NanStamp", Scan("nan"), ""}, Case{"InfiniteStamp", Scan("-inf"), ""},
                      Case{"HugeStamp", Scan("1e300"), ""},
                      Case{"WordForARange", Scan("2.5", "0 0 0", "five"), ""}),
    NameOf);

// A beam without a usable range is a fact of every sensor, not a bad record.
TEST_F(BadInput, RangesThatAreNoNumbersOnlyCostTheirBeam) {
  for (const char* range : {"nan", "inf", "-inf", "1e300", "-5", "1e999"}) {
    const std::string log =
        folder_.FileWith("ranges.clf", WithGoodScans(Scan("2.5", "0 0 0", range)));
    EXPECT_THAT(Run(GMAPPING_SPA, LogFlags(log)).out, HasSubstr("5 scans")) << range;
  }
}

TEST_F(BadInput, OdometryThatJumpsOffTheMapIsLeftOutWithAWarning) {
  for (const char* pose : {"20000 0 0", "100000 50000 0", "-900000 0 0"}) {
    const std::string log = folder_.FileWith("jump.clf", WithGoodScans(Scan("2.5", pose)));
    for (const char* odometry : {"--odometry=wheel", "--odometry=lidar"}) {
      std::vector<std::string> flags = LogFlags(log);
      flags.emplace_back(odometry);
      const CommandResult result = Run(GMAPPING_SPA, flags);
      EXPECT_EQ(result.status, 0) << result.err;
      EXPECT_THAT(result.out, HasSubstr("5 scans")) << pose;
      EXPECT_THAT(result.err, HasSubstr("2.500 s: the odometry makes a step that no robot makes"));
    }
  }
}

TEST_F(BadInput, RangesInCentimetersAreOneLineThatAsksForTheUnit) {
  std::string log;
  for (int i = 1; i <= 5; ++i) {
    log += "FLASER 3 300 512.5 900 0 0 0 0 0 0 " + std::to_string(i) + " host 0\n";
  }
  ExpectOneLine(Run(GMAPPING_SPA, LogFlags(folder_.FileWith("cm.clf", log))),
                "no beam of any scan ended between 0.05 and 40 m");
  ExpectOneLine(Run(GMAPPING_SPA, LogFlags(folder_.FileWith("cm.clf", log))), "cm or mm");
}

TEST_F(BadInput, PathsThatCannotBeUsedAreOneLine) {
  ExpectOneLine(Run(GMAPPING_SPA, {"--log=" + folder_.Path("none")}), folder_.Path("none"));
  ExpectOneLine(Run(GMAPPING_SPA, {"--log=" + folder_.path()}),
                "expected a folder with a bag, found no file");
  ExpectOneLine(Run(GMAPPING_SPA, {"--log=/dev/null"}), "expected a regular file");
  ExpectOneLine(Run(GMAPPING_SPA, {"--log="}), "--log=FILE is missing");
  for (const std::string& folder : {good_log_ + "/below", std::string("/proc/x"), good_log_}) {
    ExpectOneLine(Run(GMAPPING_SPA, {"--log=" + good_log_, "--output_dir=" + folder}), folder);
  }
  ExpectOneLine(RunCommand({GMAPPING_SPA, "--log=" + good_log_}), "--output_dir=DIR is missing");
}

TEST_F(BadInput, FullDiskIsOneLine) {
  // A limit of one block of 512 or 1024 bytes stands for a device that fills up.
  ExpectOneLine(RunCommand({"sh", "-c", "ulimit -f 1; exec \"$@\"", "sh", GMAPPING_SPA,
                            "--log=" + good_log_, "--output_dir=" + output_dir_}),
                "cannot write");
}

class BadFlag : public BadInput, public ::testing::WithParamInterface<Case> {};

TEST_P(BadFlag, IsOneLine) {
  ExpectOneLine(Run(GMAPPING_SPA, {"--log=" + good_log_, GetParam().value}), GetParam().named);
}

INSTANTIATE_TEST_SUITE_P(
    GmappingSpa, BadFlag,
    ::testing::Values(Case{"Unknown", "--nope=1", "nope"}, Case{"Word", "more", "'more'"},
                      Case{"Backend", "--backend=foo", "no back end 'foo'"},
                      Case{"BackendPath", "--backend=/none/here.so", "/none/here.so"},
                      Case{"Odometry", "--odometry=feet", "'feet'"},
                      Case{"ScanMatcher", "--scan_matcher=eye", "'eye'"},
                      Case{"EdgeMeasurement", "--edge_measurement=none", "--edge_measurement"},
                      Case{"EdgeInformation", "--edge_information=none", "--edge_information"},
                      Case{"Correction", "--correction=nonsense",
                           "--correction: expected one of pose, trajectory, found 'nonsense'"},
                      Case{"GraphThread", "--graph_thread=later", "lockstep, async, inline"},
                      Case{"NoLockstepScans", "--lockstep_scans=0", "--lockstep_scans"},
                      Case{"NegativeTimeout", "--graph_timeout_s=-1", "--graph_timeout_s"},
                      Case{"NanTimeout", "--graph_timeout_s=nan", "--graph_timeout_s"},
                      Case{"OptimizeNever", "--optimize_every=0", "--optimize_every"},
                      Case{"NegativeRefine", "--refine=-1", "--refine"},
                      Case{"ClosureScore", "--closure_min_score=0", "--closure_min_score"},
                      Case{"NanDrift", "--closure_drift_m_per_m=nan", "--closure_drift_m_per_m"},
                      Case{"Loss", "--loss=hubert", "expected a loss out of"},
                      Case{"BackendSettings", "--backend_settings=x", "--backend_settings"},
                      Case{"NoParticles", "--particles=0", "particles"},
                      Case{"NegativeParticles", "--particles=-3", "found -3"},
                      Case{"HugeParticles", "--particles=2000000000", "found 2000000000"},
                      Case{"WordForParticles", "--particles=many", "many"},
                      Case{"NoThreads", "--threads=0", "--threads"},
                      Case{"HugeThreads", "--threads=2000000", "--threads"},
                      Case{"NoResolution", "--resolution_m=0", "--resolution_m"},
                      Case{"TinyResolution", "--resolution_m=1e-9", "--resolution_m"},
                      Case{"NanResolution", "--resolution_m=nan", "--resolution_m"},
                      Case{"ShortLaserPose", "--laser_pose=1,2", "--laser_pose=1,2"},
                      Case{"HugeLaserPose", "--laser_pose=1e9,0,0", "--laser_pose=1e9"},
                      Case{"NanLaserPose", "--laser_pose=1,2,nan", "--laser_pose"},
                      Case{"WordForFov", "--fov_deg=abc", "--fov_deg=abc"},
                      Case{"NanFov", "--fov_deg=nan", "--fov_deg=nan"},
                      Case{"BadRecordPolicy", "--bad_record=maybe", "maybe"},
                      Case{"Guesses", "--initial_guesses=2000000000", "--initial_guesses"},
                      Case{"NanUsableRange", "--usable_range_m=nan", "--usable_range_m"},
                      Case{"NanOccupiedThreshold", "--occupied_threshold=nan",
                           "--occupied_threshold"},
                      Case{"MissingFlagFile", "--flagfile=/none/here", "/none/here"},
                      Case{"WaitWithoutView", "--view_wait", "--view_wait needs --view"},
                      Case{"KeepWithoutView", "--view_keep", "--view_keep needs --view"}),
    NameOf);

TEST_F(BadInput, TooManyHalvingsOfHillClimbingAreOneLine) {
  ExpectOneLine(Run(GMAPPING_SPA, {"--log=" + good_log_, "--scan_matcher=hill_climbing",
                                   "--match_refinements=100000"}),
                "--match_refinements");
}

TEST_F(BadInput, WorldWithoutAPathIsOneLineThatNamesTheFlag) {
  const std::string world = folder_.Path("alone.yaml");
  std::filesystem::copy_file(WORLDS_FOLDER "/empty_hall.yaml", world);
  ExpectOneLine(Run(SIMULATE, {"--world=" + world}), "--path=FILE is missing");
}

class BadSimulateFlag : public BadInput, public ::testing::WithParamInterface<Case> {};

TEST_P(BadSimulateFlag, IsOneLine) {
  ExpectOneLine(Run(SIMULATE, {"--world=" WORLDS_FOLDER "/paper_building.yaml", GetParam().value}),
                GetParam().named);
}

INSTANTIATE_TEST_SUITE_P(
    Simulate, BadSimulateFlag,
    ::testing::Values(Case{"NoWorld", "--world=", "--world"},
                      Case{"MissingWorld", "--world=/none.yaml", "/none"},
                      Case{"MissingPath", "--path=/none.yaml", "/none.yaml"},
                      Case{"Unknown", "--nope=1", "nope"}, Case{"Word", "more", "'more'"},
                      Case{"AngularResolution", "--angular_resolution=0.7", "--angular_resolution"},
                      Case{"FieldOfView", "--fov_deg=361", "--fov_deg"},
                      Case{"WheelBase", "--wheel_base_factor=0", "--wheel_base_factor"},
                      Case{"FieldOfViewThatNoBeamsDivide", "--fov_deg=100.1", "--fov_deg"},
                      Case{"MountWithoutAngle", "--laser_mount=0,0", "--laser_mount"},
                      Case{"MountOfWords", "--laser_mount=0,0,back", "'back'"},
                      Case{"CoverWithoutEnd", "--cover=1,2,3", "--cover"},
                      Case{"CoverBackInTime", "--cover=2,1", "--cover"},
                      Case{"GapsOfWords", "--scan_gaps=1;2", "--scan_gaps"},
                      Case{"NoScanLeft", "--scan_gaps=0,1e6", "expected a scan"},
                      Case{"Wheels", "--wheels=round", "noisy, exact, silent"},
                      Case{"NegativeCrowd", "--crowd=-1", "--crowd"},
                      Case{"PedestrianWithoutObstacles", "--walking_pedestrian", "obstacles"},
                      Case{"MissingObstacles", "--obstacles=/none.yaml", "/none.yaml"},
                      Case{"NanSpeed", "--max_speed=nan", "--max_speed"},
                      Case{"OutputBelowProc", "--output_dir=/proc/x", "/proc/x"}),
    NameOf);

}  // namespace
}  // namespace gmapping_spa::apps
