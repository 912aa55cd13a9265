// SPDX-License-Identifier: BSD-3-Clause
// What convert_log writes holds the same scans as what it read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/apps/input_file.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/sensor/open_log.h"
#include "tests/frontend/rosbag/small_bag.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::conversion {
namespace {

using sensor::LaserScan;
using ::testing::HasSubstr;

std::vector<LaserScan> ScansOf(const std::string& path) {
  const std::unique_ptr<sensor::LogReader> reader =
      rosbag::IsBag(path) ? rosbag::OpenBag(path, {}).reader
                          : sensor::OpenCarmenLog(apps::OpenInput(path), path, {});
  std::vector<LaserScan> scans;
  while (std::optional<LaserScan> scan = reader->Next()) scans.push_back(std::move(*scan));
  return scans;
}

class ConvertLog : public testing::Test {
 protected:
  std::string Convert(const std::string& from, const std::string& name,
                      const std::vector<std::string>& flags = {}) {
    std::vector<std::string> words = {CONVERT_LOG, "--log=" + from,
                                      "--output=" + folder_.Path(name)};
    words.insert(words.end(), flags.begin(), flags.end());
    result_ = RunCommand(words);
    EXPECT_EQ(result_.status, 0) << result_.err;
    return folder_.Path(name);
  }

  TemporaryFolder folder_;
  CommandResult result_;
};

void ExpectSame(const std::vector<LaserScan>& found, const std::vector<LaserScan>& expected,
                double range_tolerance_m, double angle_tolerance_rad) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].stamp_s, expected[i].stamp_s);
    EXPECT_EQ(found[i].odom_T_robot, expected[i].odom_T_robot);
    EXPECT_NEAR(found[i].robot_T_laser.x, expected[i].robot_T_laser.x, 1e-12);
    EXPECT_NEAR(found[i].robot_T_laser.theta, expected[i].robot_T_laser.theta, 1e-12);
    ASSERT_EQ(found[i].beams.size(), expected[i].beams.size());
    for (std::size_t k = 0; k < found[i].beams.size(); ++k) {
      const sensor::Beam &a = found[i].beams[k], &b = expected[i].beams[k];
      EXPECT_EQ(a.status, b.status);
      EXPECT_NEAR(a.range_m, b.range_m, range_tolerance_m);
      EXPECT_NEAR(a.angle_rad, b.angle_rad, angle_tolerance_rad);
    }
  }
}

constexpr const char* kCarmenLog =
    "PARAM robot_frontlaser_offset 0.123 nohost 0\n"
    "PARAM robot_frontlaser_angular_offset 0.3 nohost 0\n"
    "ODOM 0.1 0.2 0.3 0 0 0 1700000000.100001 nohost 0\n"
    "FLASER 3 1.51 81.83 0 0.1 0 0 0.7 -0.3 3.1 1700000000.500003 nohost 0.5\n"
    "ROBOTLASER1 0 -0.5 1.0 0.5 20 0.01 0 3 1 20 3 0 0.5 0 2 0 0.5 2 0 0 0 0 0 1700000001.5 h 1\n"
    "ODOM 0.5 0.25 2.5 0 0 0 1700000001.75 nohost 1\n"
    "RAWLASER1 0 -0.5 1.0 0.5 30 0.01 0 3 1 nan 33 0 1700000001.75 nohost 0.6\n"
    "ODOM 1 0 0.5 0 0 0 1700000002.0 nohost 1\n";

TEST_F(ConvertLog, KeepsACarmenLogThroughEveryFormat) {
  const std::string carmen = folder_.FileWith("log.clf", kCarmenLog);
  const std::vector<LaserScan> expected = ScansOf(carmen);
  ASSERT_EQ(expected.size(), 3u);
  for (const char* name : {"a.bag", "a.mcap", "a.db3"}) {
    const std::string bag = Convert(carmen, name);
    EXPECT_THAT(result_.out, HasSubstr("3 scans, 2 of them with odometry, and 3 odometry records"));
    ExpectSame(ScansOf(bag), expected, 1e-5, 1e-6);
    ExpectSame(ScansOf(Convert(bag, "back.clf")), ScansOf(bag), 0.0, 0.0);
  }
  ExpectSame(ScansOf(Convert(carmen, "same.clf")), expected, 0.0, 1e-15);
}

TEST_F(ConvertLog, KeepsABagToTheLastBit) {
  rosbag::SmallBag bag(folder_.Path("from"), "bag");
  rosbag::WriteDrive(&bag, 40);
  const std::string from = bag.Finish();
  for (const char* name : {"a.bag", "a.mcap", "a.db3", "a.clf"}) {
    for (const char* flag : {"--compress", "--nocompress"}) {
      ExpectSame(ScansOf(Convert(from, name, {flag})), ScansOf(from), 0.0, 0.0);
      std::filesystem::remove(folder_.Path(name));
    }
  }
}

TEST_F(ConvertLog, SaysWhatAFormatCannotHold) {
  rosbag::SmallBag bag(folder_.Path("from"), "mcap");
  bag.Scan(rosbag::kSecond_ns, {.time_increment_s = 0.01f});
  const std::string from = bag.Finish();
  Convert(from, "a.clf");
  EXPECT_THAT(result_.err, HasSubstr("1 scans lose the time"));
  EXPECT_NEAR(ScansOf(Convert(from, "a.bag")).at(0).sweep_s, 0.04, 1e-7);
}

TEST_F(ConvertLog, WritesNothingWhereItFails) {
  const std::string log = folder_.FileWith("log.clf", "no log\n");
  for (const std::string name : {"a.bag", "a.txt"}) {
    const CommandResult result =
        RunCommand({CONVERT_LOG, "--log=" + log, "--output=" + folder_.Path(name)});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  }
}

TEST_F(ConvertLog, InspectLogTellsTopicsAndLasersOfWhatItWrote) {
  const std::string bag = Convert(folder_.FileWith("log.clf", kCarmenLog), "a.mcap");
  const CommandResult text = RunCommand({INSPECT_LOG, "--log=" + bag});
  EXPECT_THAT(text.out, HasSubstr("/scan: 3 messages"));
  EXPECT_THAT(text.out, HasSubstr("sensor_msgs/LaserScan: read for scans"));
  const CommandResult json = RunCommand({INSPECT_LOG, "--log=" + bag, "--json"});
  const nlohmann::json report = nlohmann::json::parse(json.out);
  EXPECT_EQ(report["bag"]["odometry_from"], "/odom");
  EXPECT_EQ(report["bag"]["base_frame"], "base_link");
  EXPECT_EQ(report["bag"]["topics"].size(), 3u);
  EXPECT_NEAR(report["bag"]["lasers"][0]["x_m"].get<double>(), 0.123, 1e-12);
  EXPECT_EQ(report["laser_pose"]["from"], "the transforms");
}

}  // namespace
}  // namespace gmapping_spa::conversion
