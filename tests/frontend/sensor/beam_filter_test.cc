// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/beam_filter.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/frontend/sensor/fake_record_reader.h"

namespace gmapping_spa::sensor {
namespace {

// Makes beams invalid whose range is the largest of what it has seen.
class LargestFilter : public BeamFilter {
 public:
  void Learn(const std::vector<const LaserScan*>& scans) override {
    for (const LaserScan* scan : scans) largest_m_ = std::max(largest_m_, scan->beams[0].range_m);
  }
  std::int64_t Apply(LaserScan* scan) const override {
    if (scan->beams[0].range_m != largest_m_) return 0;
    scan->beams[0].status = BeamStatus::kInvalid;
    return 1;
  }
  const char* count_name() const override { return "largest"; }

 private:
  double largest_m_ = 0.0;
};

TEST(BeamFilterReader, LearnsFromTwoHundredScansBeforeItChangesThem) {
  std::vector<LogRecord> records;
  for (int k = 0; k < 450; ++k) {
    records.emplace_back(OdometryRecord{k - 0.5, {}});
    records.emplace_back(ScanWithOdometry(k, {1.0 + k % 300}));
  }
  std::vector<std::unique_ptr<BeamFilter>> filters;
  filters.push_back(std::make_unique<LargestFilter>());
  BeamFilterReader reader(std::make_unique<FakeRecordReader>(std::move(records)),
                          std::move(filters));
  std::vector<double> changed_s;
  int scans = 0, others = 0;
  while (const std::optional<LogRecord> record = reader.Next()) {
    const auto* scan = std::get_if<ScanRecord>(&*record);
    if (scan == nullptr) {
      EXPECT_EQ(others++, scans) << "the order of records has changed";
      continue;
    }
    EXPECT_EQ(scan->scan.stamp_s, scans++);
    if (scan->scan.beams[0].status == BeamStatus::kInvalid) changed_s.push_back(scan->scan.stamp_s);
  }
  EXPECT_EQ(scans, 450);
  // The largest of the first 200, then that of the next 200, which is the largest for good.
  EXPECT_EQ(changed_s, (std::vector<double>{199.0, 299.0}));
  EXPECT_EQ(reader.counts().at("largest"), 2);
  EXPECT_EQ(reader.counts().at("of_the_source"), 7);
}

}  // namespace
}  // namespace gmapping_spa::sensor
