// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/log_validator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/frontend/sensor/fake_record_reader.h"

namespace gmapping_spa::sensor {
namespace {

using testing::ThrowsMessage;

struct Finding {
  const char* count;
  std::vector<LogRecord> records;
  const char* error;
};

std::vector<Finding> Findings() {
  return {{"gaps",
           {ScanWithOdometry(1), ScanWithOdometry(6), ScanWithOdometry(11.5)},
           "log.clf:3: expected the next scan within 5.000000 s, found it 5.500000 s later"},
          {"duplicate_stamps",
           {ScanWithOdometry(1, {1.0}), ScanWithOdometry(2, {1.0}), ScanWithOdometry(2, {2.0})},
           "log.clf:3: expected a stamp of its own, found that of another scan"},
          {"changed_beam_counts",
           {ScanWithOdometry(1, {1.0}), ScanWithOdometry(2, {1.0, 2.0}),
            ScanWithOdometry(3, {1.0, 2.0})},
           "log.clf:2: expected 1 beams as before, found 2"}};
}

LogValidator Validator(const std::vector<LogRecord>& records, const LogOptions& options) {
  return {TimeOrderedReader(std::make_unique<FakeRecordReader>(records), "log.clf", options),
          "log.clf", options};
}

TEST(LogValidator, CountsEachFindingAndDeliversEveryScanUnderSkip) {
  for (const Finding& finding : Findings()) {
    LogValidator validator = Validator(finding.records, {});
    std::int64_t num_scans = 0;
    while (validator.Next()) ++num_scans;
    EXPECT_EQ(num_scans, 3) << finding.count;
    const LogCounts counts = validator.counts();
    EXPECT_EQ(counts.at("scans"), 3) << finding.count;
    for (const char* name : {"gaps", "duplicate_stamps", "changed_beam_counts"}) {
      EXPECT_EQ(counts.at(name), name == std::string(finding.count) ? 1 : 0)
          << name << " where there are " << finding.count;
    }
  }
}

TEST(LogValidator, CountsBeamsByStatus) {
  ScanRecord record = ScanWithOdometry(1, {1.0, 2.0, 40.0, 0.0, 0.0, 0.0});
  record.scan.beams[2].status = BeamStatus::kNoReturn;
  for (int i = 3; i < 6; ++i) record.scan.beams[i].status = BeamStatus::kInvalid;
  LogValidator validator = Validator({record, ScanWithOdometry(2)}, {});
  while (validator.Next()) {
  }
  const LogCounts counts = validator.counts();
  EXPECT_EQ(counts.at("beams_hit"), 3);
  EXPECT_EQ(counts.at("beams_no_return"), 1);
  EXPECT_EQ(counts.at("beams_invalid"), 3);
}

TEST(LogValidator, NamesTheLineOfTheFirstFindingUnderFail) {
  LogOptions options;
  options.bad_record = BadRecordPolicy::kFail;
  for (const Finding& finding : Findings()) {
    LogValidator validator = Validator(finding.records, options);
    EXPECT_THAT(
        [&] {
          while (validator.Next()) {
          }
        },
        ThrowsMessage<std::runtime_error>(finding.error));
  }
}

}  // namespace
}  // namespace gmapping_spa::sensor
