// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/log_pipeline.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "frontend/sensor/beam_filter.h"
#include "frontend/sensor/laser_mounting.h"
#include "frontend/sensor/log_validator.h"
#include "frontend/sensor/max_range_filter.h"
#include "frontend/sensor/robot_beam_filter.h"
#include "frontend/sensor/time_ordered_reader.h"

namespace gmapping_spa::sensor {
namespace {

void Require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

void CheckOptions(const LogOptions& options) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  Require(options.range_min_m >= 0.0, "the minimum range must not be negative");
  Require(std::isfinite(options.usable_range_m) && options.usable_range_m > options.range_min_m,
          "the usable range must be finite and above the minimum range");
  Require(!options.fov_rad || (*options.fov_rad > 0.0 && *options.fov_rad <= kTurn),
          "the field of view must be above 0 and at most one turn");
  Require(!options.angle_min_rad || std::abs(*options.angle_min_rad) <= kTurn,
          "the first angle must be within one turn of 0");
  Require(!options.robot_T_laser || options.robot_T_laser->IsFinite(),
          "the pose of the laser must be finite");
  Require(options.reorder_window_s >= 0.0, "the reorder window must not be negative");
  Require(options.gap_s > 0.0, "the length of a gap must be positive");
}

std::unique_ptr<LogReader> ScansOf(std::unique_ptr<RecordReader> records, const std::string& name,
                                   const LogOptions& options) {
  auto mounted = std::make_unique<LaserMountingReader>(std::move(records));
  std::vector<std::unique_ptr<BeamFilter>> filters;
  filters.push_back(std::make_unique<MaxRangeFilter>());
  filters.push_back(std::make_unique<RobotBeamFilter>());
  auto filtered = std::make_unique<BeamFilterReader>(std::move(mounted), std::move(filters));
  TimeOrderedReader ordered(std::move(filtered), name, options);
  return std::make_unique<LogValidator>(std::move(ordered), name, options);
}

}  // namespace gmapping_spa::sensor
