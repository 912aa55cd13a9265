// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/packed_ranges.h"

#include <gtest/gtest.h>

#include <cereal/types/vector.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "frontend/session/archive.h"

namespace gmapping_spa::sensor {
namespace {

std::vector<Beam> Hits(const std::vector<double>& ranges_m) {
  std::vector<Beam> beams;
  for (const double range_m : ranges_m) beams.push_back({0.1, range_m, BeamStatus::kHit});
  return beams;
}

// As a float holds them.
void ExpectGivesBack(const std::vector<Beam>& beams) {
  const PackedRanges packed(beams);
  ASSERT_EQ(packed.size(), beams.size());
  for (std::size_t k = 0; k < beams.size(); ++k) {
    const Beam beam = packed.BeamAt(k, 0.5);
    EXPECT_EQ(beam.angle_rad, 0.5) << k;
    EXPECT_EQ(beam.range_m, static_cast<float>(beams[k].range_m)) << k;
    EXPECT_EQ(beam.status, beams[k].status) << k;
  }
}

std::size_t SavedAndLoaded(const std::vector<Beam>& beams) {
  PackedRanges packed(beams), loaded;
  session::SaveArchive save;
  save(packed);
  const std::string bytes = save.TakeBytes();
  session::LoadArchive load({bytes.data(), bytes.size()});
  load(loaded);
  EXPECT_TRUE(loaded == packed);
  return bytes.size();
}

TEST(PackedRanges, GiveBackWholeCentimetersAsTheyAreWritten) {
  std::vector<double> ranges_m;
  for (int cm = 1; cm <= 32767; cm += 7) {
    ranges_m.push_back(std::strtod((std::to_string(cm) + "e-2").c_str(), nullptr));
  }
  ExpectGivesBack(Hits(ranges_m));
}

TEST(PackedRanges, GiveBackWholeMillimetersAndWhateverElse) {
  ExpectGivesBack(Hits({1.234, 0.001, 32.767}));
  ExpectGivesBack(Hits({1.234, 40.001}));  // more than a count holds
  ExpectGivesBack(Hits({1.0 / 3.0, 2.0}));
  ExpectGivesBack(Hits({1e-12, 1e9}));
  ExpectGivesBack({});
}

TEST(PackedRanges, GiveBackWhatBeamsSay) {
  ExpectGivesBack({{0, 2.5, BeamStatus::kHit},
                   {0, 20.0, BeamStatus::kNoReturn},
                   {0, 0.0, BeamStatus::kInvalid},
                   {0, 0.7, BeamStatus::kHit}});
  ExpectGivesBack({{0, 1.0 / 3.0, BeamStatus::kHit},
                   {0, std::sqrt(500.0), BeamStatus::kNoReturn},
                   {0, 0.0, BeamStatus::kInvalid}});
}

TEST(PackedRanges, WithoutANumberAreKept) {
  const PackedRanges packed(Hits({std::numeric_limits<double>::infinity(), 1.0}));
  EXPECT_EQ(packed.BeamAt(0, 0.0).range_m, std::numeric_limits<double>::infinity());
  EXPECT_EQ(packed.BeamAt(1, 0.0).range_m, 1.0);
}

TEST(PackedRanges, AreEqualWhereAllRangesAndStatusesAre) {
  EXPECT_TRUE(PackedRanges(Hits({1.25, 2.5})) == PackedRanges(Hits({1.25, 2.5})));
  EXPECT_FALSE(PackedRanges(Hits({1.25, 2.5})) == PackedRanges(Hits({1.25, 2.501})));
  EXPECT_FALSE(PackedRanges(Hits({1.25})) == PackedRanges({{0, 1.25, BeamStatus::kNoReturn}}));
}

TEST(PackedRanges, AreSavedAlikeHoweverTheyAreHeld) {
  EXPECT_EQ(SavedAndLoaded(Hits({1.25, 2.5})), SavedAndLoaded(Hits({1.0 / 3.0, 2.5})));
}

}  // namespace
}  // namespace gmapping_spa::sensor
