// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gmapping_spa::ros {
namespace {

// As diagnostic_msgs has them.
struct KeyValue {
  std::string key, value;
};
struct DiagnosticStatus {
  enum : int { OK = 0, WARN = 1 };
  int level = OK;
  std::string name, message;
  std::vector<KeyValue> values;
};
struct DiagnosticArray {
  std::vector<DiagnosticStatus> status;
};

TEST(DiagnosticsOf, TellsWhereTheScansWent) {
  const auto all_used = DiagnosticsOf<DiagnosticArray>({}, OldMap::kNone, "/slam");
  ASSERT_EQ(all_used.status.size(), 1u);
  EXPECT_EQ(all_used.status[0].name, "/slam: scans");
  EXPECT_EQ(all_used.status[0].level, DiagnosticStatus::OK);
  ScanCounts counts;
  counts.lost = 3;
  const auto some_lost = DiagnosticsOf<DiagnosticArray>(counts, OldMap::kNone, "/slam");
  EXPECT_EQ(some_lost.status[0].level, DiagnosticStatus::WARN);
  EXPECT_EQ(some_lost.status[0].values[0].key, "lost");
  EXPECT_EQ(some_lost.status[0].values[0].value, "3");
}

TEST(DiagnosticsOf, WarnsWhereNoScansComeAndWhereTheyWait) {
  const auto message_of = [](const ScanCounts& counts) {
    const auto status = DiagnosticsOf<DiagnosticArray>(counts, OldMap::kNone, "/slam").status.at(0);
    return status.level == DiagnosticStatus::WARN ? status.message : "";
  };
  EXPECT_EQ(message_of({.silent_s = 9.0}), "");
  EXPECT_EQ(message_of({.silent_s = 11.0}), "no scan has come yet");
  EXPECT_EQ(message_of({.received = 5, .silent_s = 11.0}), "no scans come any more");
  EXPECT_EQ(message_of({.received = 60, .waiting = 10}), "");
  EXPECT_THAT(message_of({.received = 60, .waiting = 51}), testing::HasSubstr("is behind"));
}

TEST(DiagnosticsOf, WarnsWhileTheRobotIsNotFoundInTheOldMap) {
  const auto searched = DiagnosticsOf<DiagnosticArray>({}, OldMap::kSearched, "/slam");
  ASSERT_EQ(searched.status.size(), 2u);
  EXPECT_EQ(searched.status[1].name, "/slam: localization");
  EXPECT_EQ(searched.status[1].level, DiagnosticStatus::WARN);
  EXPECT_NE(searched.status[1].message.find("there is no map -> odom"), std::string::npos);
  const auto found = DiagnosticsOf<DiagnosticArray>({}, OldMap::kFound, "/slam");
  EXPECT_EQ(found.status[1].level, DiagnosticStatus::OK);
}

}  // namespace
}  // namespace gmapping_spa::ros
