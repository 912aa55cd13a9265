// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/beams.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace gmapping_spa::sensor {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double LastAngle(const BeamAngles& angles, std::size_t num_beams) {
  return angles.first_rad + angles.step_rad * static_cast<double>(num_beams - 1);
}

TEST(TabulatedAngles, AreThoseOfTheSickLms) {
  const struct {
    std::size_t num_beams;
    double step_deg, last_deg;
  } table[] = {{180, 1.0, 89.0}, {181, 1.0, 90.0}, {360, 0.5, 89.5}, {361, 0.5, 90.0}};
  for (const auto& row : table) {
    const BeamAngles angles = TabulatedAngles(row.num_beams);
    EXPECT_NEAR(angles.first_rad, -90.0 * kDeg, 1e-12) << row.num_beams;
    EXPECT_NEAR(angles.step_rad, row.step_deg * kDeg, 1e-12) << row.num_beams;
    EXPECT_NEAR(LastAngle(angles, row.num_beams), row.last_deg * kDeg, 1e-12) << row.num_beams;
  }
}

TEST(TabulatedAngles, SpreadOtherNumbersFromEndToEnd) {
  EXPECT_NEAR(TabulatedAngles(682).first_rad, -90.0 * kDeg, 1e-12);
  EXPECT_NEAR(LastAngle(TabulatedAngles(682), 682), 90.0 * kDeg, 1e-12);
  EXPECT_NEAR(LastAngle(TabulatedAngles(2), 2), 90.0 * kDeg, 1e-12);
}

TEST(TabulatedAngles, PointASingleBeamStraightAhead) {
  EXPECT_EQ(TabulatedAngles(1).first_rad, 0.0);
}

TEST(OverriddenAngles, FieldOfViewIsCentredUnlessTheFirstAngleIsGivenToo) {
  LogOptions options;
  options.fov_rad = 240.0 * kDeg;
  BeamAngles angles = OverriddenAngles(TabulatedAngles(241), 241, options);
  EXPECT_NEAR(angles.first_rad, -120.0 * kDeg, 1e-12);
  EXPECT_NEAR(angles.step_rad, 1.0 * kDeg, 1e-12);

  options.angle_min_rad = -100.0 * kDeg;
  angles = OverriddenAngles(TabulatedAngles(241), 241, options);
  EXPECT_NEAR(angles.first_rad, -100.0 * kDeg, 1e-12);
  EXPECT_NEAR(angles.step_rad, 1.0 * kDeg, 1e-12);
}

TEST(OverriddenAngles, FirstAngleAloneKeepsTheStep) {
  LogOptions options;
  options.angle_min_rad = -0.5;
  const BeamAngles angles = OverriddenAngles({-1.0, 0.25}, 5, options);
  EXPECT_EQ(angles.first_rad, -0.5);
  EXPECT_EQ(angles.step_rad, 0.25);
}

TEST(OverriddenAngles, FlippedLaserMeasuresClockwise) {
  LogOptions options;
  options.flipped = true;
  const BeamAngles angles = OverriddenAngles({-1.0, 0.25}, 5, options);
  EXPECT_EQ(angles.first_rad, 1.0);
  EXPECT_EQ(angles.step_rad, -0.25);
}

TEST(MakeBeams, RangeDecidesTheStatus) {
  const struct {
    double range_m;
    BeamStatus status;
    double beam_range_m;
  } table[] = {{kNan, BeamStatus::kInvalid, 0.0},    {-1.0, BeamStatus::kInvalid, 0.0},
               {-kInf, BeamStatus::kInvalid, 0.0},   {0.0, BeamStatus::kInvalid, 0.0},
               {0.049, BeamStatus::kInvalid, 0.0},   {0.05, BeamStatus::kHit, 0.05},
               {39.99, BeamStatus::kHit, 39.99},     {40.0, BeamStatus::kNoReturn, 40.0},
               {81.83, BeamStatus::kNoReturn, 40.0}, {kInf, BeamStatus::kNoReturn, 40.0}};
  std::vector<double> ranges_m;
  for (const auto& row : table) ranges_m.push_back(row.range_m);
  const std::vector<Beam> beams = MakeBeams(ranges_m, {-1.0, 0.5}, 0.05, 40.0);
  ASSERT_EQ(beams.size(), std::size(table));
  for (std::size_t i = 0; i < beams.size(); ++i) {
    EXPECT_EQ(beams[i].status, table[i].status) << table[i].range_m;
    EXPECT_EQ(beams[i].range_m, table[i].beam_range_m) << table[i].range_m;
    EXPECT_EQ(beams[i].angle_rad, -1.0 + 0.5 * static_cast<double>(i));
  }
}

}  // namespace
}  // namespace gmapping_spa::sensor
