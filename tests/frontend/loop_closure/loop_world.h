// SPDX-License-Identifier: BSD-3-Clause
// A building with a loop, a drive around it, and odometry that drifts.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_LOOP_WORLD_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_LOOP_WORLD_H_

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::synthetic {

// A corridor 3 m wide around a block, its middle line 48 m long. Niches and pillars make every part
// of it look different.
inline Walls Ring() {
  Walls walls;
  AddPolygon(
      {{0, 0},      {4, 0},     {4, -0.8},  {5, -0.8},    {5, 0},     {11, 0},     {11, 0.5},
       {11.4, .5},  {11.4, 0},  {18, 0},    {18, 5},      {18.9, 5},  {18.9, 6.5}, {18, 6.5},
       {18, 12},    {13, 12},   {13, 12.6}, {12.4, 12.6}, {12.4, 12}, {7.5, 12},   {7.5, 11.5},
       {6.8, 11.5}, {6.8, 12},  {0, 12},    {0, 8},       {-1, 8},    {-1, 7},     {0, 7},
       {0, 3.2},    {0.4, 3.2}, {0.4, 2.9}, {0, 2.9}},
      0.0, &walls);
  AddPolygon({{3, 3},    {7, 3},      {7, 3.6},  {8, 3.6}, {8, 3},     {15, 3},   {15, 7},
              {14.5, 7}, {14.5, 7.4}, {15, 7.4}, {15, 9},  {10, 9},    {10, 8.4}, {9, 8.4},
              {9, 9},    {3, 9},      {3, 5},    {3.5, 5}, {3.5, 4.5}, {3, 4.5}},
             0.0, &walls);
  return walls;
}

// Where the middle line of the Ring is after `path_length_m` of driving from (3, 1.5),
// counter-clockwise; corners are cut by 1 m, so that the heading turns on the way.
inline backend::SE2 OnRing(double path_length_m) {
  struct Side {
    double from_x, from_y, length_m, theta;
  };
  constexpr double kQuarter = std::numbers::pi / 2;
  static constexpr Side kSides[] = {{1.5, 1.5, 15, 0},
                                    {16.5, 1.5, 9, kQuarter},
                                    {16.5, 10.5, 15, 2 * kQuarter},
                                    {1.5, 10.5, 9, 3 * kQuarter}};
  double along_m = std::fmod(path_length_m + 1.5, 48.0);
  int side = 0;
  while (along_m >= kSides[side].length_m) along_m -= kSides[side++].length_m;
  const Side& at = kSides[side];
  // Turns by a quarter from 1 m before the corner to 1 m behind it.
  const double before_m = at.length_m - along_m;
  double turn = 0.0;
  if (before_m < 1.0) turn = kQuarter * (1.0 - before_m) / 2;
  if (along_m < 1.0) turn = -kQuarter * (1.0 - along_m) / 2;
  return {at.from_x + along_m * std::cos(at.theta), at.from_y + along_m * std::sin(at.theta),
          backend::WrapAngle(at.theta + turn)};
}

// Poses on the Ring every `step_m`, in the frame of the Ring.
inline std::vector<backend::SE2> DriveOnRing(double from_m, double to_m, double step_m) {
  std::vector<backend::SE2> poses;
  for (int k = 0; from_m + step_m * k <= to_m; ++k) poses.push_back(OnRing(from_m + step_m * k));
  return poses;
}

struct Drift {
  double scale = 1.0;          // of the way
  double rad_per_m = 0.0;      // of the heading
  double lateral_per_m = 0.0;  // to the left
};

// The same drive by odometry that drifts, starting at `start`.
inline std::vector<backend::SE2> WithDrift(const std::vector<backend::SE2>& poses,
                                           const Drift& drift, const backend::SE2& start = {}) {
  std::vector<backend::SE2> drifted = {start};
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const backend::SE2 step = Between(poses[k - 1], poses[k]);
    const double path_length_m = step.translation().norm();
    drifted.push_back(drifted.back() *
                      backend::SE2{drift.scale * step.x,
                                   drift.scale * step.y + drift.lateral_per_m * path_length_m,
                                   step.theta + drift.rad_per_m * path_length_m});
  }
  return drifted;
}

// What a laser sees at each of the poses.
inline std::vector<sensor::LaserScan> ScansAt(const std::vector<backend::SE2>& poses,
                                              const Walls& walls, const Laser& laser = {}) {
  std::vector<sensor::LaserScan> scans;
  for (const backend::SE2& pose : poses) {
    scans.push_back(Scan(walls, pose, laser));
    scans.back().index = static_cast<std::int64_t>(scans.size()) - 1;
    scans.back().stamp_s = 0.1 * static_cast<double>(scans.back().index);
  }
  return scans;
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_LOOP_WORLD_H_
