// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/open_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/apps/input_file.h"
#include "tests/real_data.h"

namespace gmapping_spa::sensor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string kLog =
    "# message_name [message contents] ipc_timestamp ipc_hostname logger_timestamp\n"
    "PARAM robot_frontlaser_offset 0.1 nohost 0\n"
    "ODOM 0 0 0 0 0 0 100.0 nohost 0\n"
    "FLASER 3 1.5 2.5 81.83 0.1 0 0 0 0 0 100.5 nohost 0.5\n"
    "RAWLASER1 0 -0.5 1.0 0.5 80 0.01 0 3 1 2 3 1 7 100.25 nohost 0.6\n"
    "ODOM 1 0 0.5 0 0 0 101.0 nohost 1\n"
    "ROBOTLASER1 0 -0.5 1.0 0.5 80 0.01 0 3 1 nan 3 0 0 0 0 0 0 0 0 0 0 0 0 101.5 nohost 1.5\n";

std::unique_ptr<LogReader> Open(const std::string& text, const LogOptions& options = {}) {
  return OpenCarmenLog(std::make_unique<std::istringstream>(text), "log.clf", options);
}

// Reads to the end. What a reader promises must hold whatever is in the log: sane scans, or one
// line of explanation.
void ExpectSaneScansOrOneLine(const std::string& text, const LogOptions& options) {
  try {
    const std::unique_ptr<LogReader> reader = Open(text, options);
    std::vector<std::int64_t> indices;
    while (const std::optional<LaserScan> scan = reader->Next()) {
      indices.push_back(scan->index);
      ASSERT_TRUE(std::isfinite(scan->stamp_s));
      ASSERT_TRUE(scan->odom_T_robot.IsFinite());
      ASSERT_TRUE(scan->robot_T_laser.IsFinite());
      ASSERT_FALSE(scan->beams.empty());
      for (const Beam& beam : scan->beams) {
        ASSERT_TRUE(std::isfinite(beam.angle_rad));
        ASSERT_TRUE(beam.range_m >= 0.0 && beam.range_m <= options.usable_range_m);
      }
    }
    ASSERT_FALSE(indices.empty());
    std::sort(indices.begin(), indices.end());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      ASSERT_EQ(indices[i], static_cast<std::int64_t>(i));
    }
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    ASSERT_TRUE(message.starts_with("log.clf:"));
    ASSERT_TRUE(
        std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  }
}

class DamagedLog : public testing::TestWithParam<BadRecordPolicy> {
 protected:
  LogOptions Options() const {
    LogOptions options;
    options.bad_record = GetParam();
    return options;
  }
};

TEST_P(DamagedLog, CutOffAnywhereGivesSaneScansOrOneLine) {
  for (std::size_t size = 0; size <= kLog.size(); ++size) {
    ASSERT_NO_FATAL_FAILURE(ExpectSaneScansOrOneLine(kLog.substr(0, size), Options())) << size;
  }
}

TEST_P(DamagedLog, AnyByteReplacedGivesSaneScansOrOneLine) {
  constexpr char kReplacements[] = {'\0', '\n', '\r', ' ', '-', '.', '0', '9', 'e', 'n', '\xff'};
  for (std::size_t i = 0; i < kLog.size(); ++i) {
    for (const char replacement : kReplacements) {
      std::string log = kLog;
      log[i] = replacement;
      ASSERT_NO_FATAL_FAILURE(ExpectSaneScansOrOneLine(log, Options())) << "byte " << i;
    }
    for (int bit = 0; bit < 8; ++bit) {
      std::string log = kLog;
      log[i] = static_cast<char>(log[i] ^ (1 << bit));
      ASSERT_NO_FATAL_FAILURE(ExpectSaneScansOrOneLine(log, Options())) << "byte " << i;
    }
  }
}

TEST_P(DamagedLog, AnyWordReplacedGivesSaneScansOrOneLine) {
  const std::string replacements[] = {
      "",           "nan",    "-inf", "1e308", "-1e308",
      "1e-320",     "1e999",  "-1",   "0",     "1",
      "1000000000", "FLASER", "0x10", "+1",    "18446744073709551616"};
  for (std::size_t begin = 0; begin < kLog.size();) {
    const std::size_t end = std::min(kLog.find_first_of(" \n", begin), kLog.size());
    for (const std::string& replacement : replacements) {
      std::string log = kLog;
      log.replace(begin, end - begin, replacement);
      ASSERT_NO_FATAL_FAILURE(ExpectSaneScansOrOneLine(log, Options())) << log;
    }
    begin = end + 1;
  }
}

INSTANTIATE_TEST_SUITE_P(OpenCarmenLog, DamagedLog,
                         testing::Values(BadRecordPolicy::kSkip, BadRecordPolicy::kFail));

TEST(OpenCarmenLog, OrdersInterpolatesAndCounts) {
  const std::unique_ptr<LogReader> reader = Open(kLog);
  const std::optional<LaserScan> first = reader->Next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->stamp_s, 100.25);
  EXPECT_EQ(first->index, 1);
  EXPECT_NEAR(first->odom_T_robot.theta, 0.125, 1e-12);
  EXPECT_EQ(first->robot_T_laser.x, 0.1);
  EXPECT_EQ(reader->Next()->stamp_s, 100.5);
  EXPECT_EQ(reader->Next()->stamp_s, 101.5);
  EXPECT_FALSE(reader->Next());
  const LogCounts counts = reader->counts();
  EXPECT_EQ(counts.at("lines"), 7);
  EXPECT_EQ(counts.at("scans"), 3);
  EXPECT_EQ(counts.at("out_of_order_scans"), 1);
  EXPECT_EQ(counts.at("duplicate_stamps"), 0);
}

TEST(OpenCarmenLog, RandomBytesAreNoLog) {
  std::string bytes;
  std::uint32_t state = 1;
  for (int i = 0; i < 100000; ++i) {
    state = state * 1664525u + 1013904223u;
    bytes += static_cast<char>(state >> 24);
  }
  const std::unique_ptr<LogReader> reader = Open(bytes);
  EXPECT_THAT([&] { reader->Next(); },
              ThrowsMessage<std::runtime_error>(HasSubstr("log.clf: no laser scans found")));
}

// Gives a whole log, then fails as a truncated gzip file does.
class FailingBuffer : public std::stringbuf {
 public:
  FailingBuffer() : std::stringbuf(kLog) {}

 protected:
  int_type underflow() override {
    const int_type next = std::stringbuf::underflow();
    if (next == traits_type::eof()) throw std::runtime_error("log.clf: truncated");
    return next;
  }
};

TEST(OpenCarmenLog, ReadErrorIsNotTakenForTheEndOfTheLog) {
  for (const bool stream_throws : {false, true}) {
    FailingBuffer buffer;
    auto in = std::make_unique<std::istream>(&buffer);
    if (stream_throws) in->exceptions(std::ios::badbit);
    const std::unique_ptr<LogReader> reader = OpenCarmenLog(std::move(in), "log.clf", {});
    EXPECT_THAT(
        [&] {
          while (reader->Next()) {
          }
        },
        ThrowsMessage<std::runtime_error>(stream_throws
                                              ? "log.clf: truncated"
                                              : "log.clf:8: expected a line, found a read error"));
  }
}

TEST(OpenCarmenLog, OptionsOutOfRangeAreRefused) {
  LogOptions options;
  options.usable_range_m = 0.01;
  EXPECT_THROW(Open(kLog, options), std::invalid_argument);
  options = {};
  options.fov_rad = 0.0;
  EXPECT_THROW(Open(kLog, options), std::invalid_argument);
  options = {};
  options.reorder_window_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Open(kLog, options), std::invalid_argument);
}

struct RealLog {
  const char* file;
  std::int64_t num_scans, num_beams, num_odometry, num_out_of_order;
  double laser_x_m;
};

class RealCarmenLog : public testing::TestWithParam<RealLog> {};

TEST_P(RealCarmenLog, IsReadWholeInOrderAndWithoutFindings) {
  const auto path = RealDataPath(std::string("carmen/") + GetParam().file);
  if (!path) GTEST_SKIP() << GetParam().file << " is not there; set GMAPPING_SPA_DATA";
  // Stricter than the default, under which everything is delivered anyway.
  LogOptions options;
  options.bad_record = BadRecordPolicy::kFail;
  const std::unique_ptr<LogReader> reader = OpenCarmenLog(apps::OpenInput(*path), *path, options);
  std::int64_t num_scans = 0;
  double previous_stamp_s = -std::numeric_limits<double>::infinity();
  std::vector<bool> seen(static_cast<std::size_t>(GetParam().num_scans));
  while (const std::optional<LaserScan> scan = reader->Next()) {
    ++num_scans;
    ASSERT_GT(scan->stamp_s, previous_stamp_s);
    previous_stamp_s = scan->stamp_s;
    ASSERT_EQ(static_cast<std::int64_t>(scan->beams.size()), GetParam().num_beams);
    ASSERT_EQ(scan->robot_T_laser, (backend::SE2{GetParam().laser_x_m, 0, 0}));
    ASSERT_FALSE(seen.at(static_cast<std::size_t>(scan->index)));
    seen[static_cast<std::size_t>(scan->index)] = true;
  }
  EXPECT_EQ(num_scans, GetParam().num_scans);
  const LogCounts counts = reader->counts();
  EXPECT_EQ(counts.at("scans"), GetParam().num_scans);
  EXPECT_EQ(counts.at("odometry_records"), GetParam().num_odometry);
  EXPECT_EQ(counts.at("out_of_order_scans"), GetParam().num_out_of_order);
  EXPECT_EQ(counts.at("unknown_records"), 0);
  EXPECT_EQ(counts.at("laser_pose_mismatches"), 0);
}

INSTANTIATE_TEST_SUITE_P(OpenCarmenLog, RealCarmenLog,
                         testing::Values(RealLog{"intel.clf.gz", 13631, 180, 26915, 631, 0.0},
                                         RealLog{"fr079.clf.gz", 4934, 360, 8951, 0, -0.04},
                                         RealLog{"aces.clf.gz", 7374, 180, 7375, 0, 0.0},
                                         RealLog{"mit-killian.clf.gz", 17480, 180, 0, 0, 0.0}),
                         [](const auto& param_info) {
                           std::string name = param_info.param.file;
                           std::erase_if(name, [](char c) { return c == '.' || c == '-'; });
                           return name;
                         });

}  // namespace
}  // namespace gmapping_spa::sensor
