// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/odometry_check.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "backend/enum_names.h"

namespace gmapping_spa::sensor {
namespace {

using backend::SE2;

constexpr backend::EnumName<OdometryFault> kFaults[] = {
    {"none", OdometryFault::kNone},
    {"first", OdometryFault::kFirst},
    {"odometry_impossible", OdometryFault::kImpossible},
    {"odometry_restart", OdometryFault::kRestart},
    {"unchanged", OdometryFault::kUnchanged},
    {"repeated_scan", OdometryFault::kRepeatedScan},
    {"odometry_missing", OdometryFault::kMissing}};

// Loggers give stamps milliseconds apart to scans that were waiting.
constexpr double kShortestPeriodS = 0.1;
// A gap in the log must not pass for the usual time between scans.
constexpr double kLongestUsualPeriodS = 5.0;
// A mean over about so many steps: longer than any bunch of scans that were waiting.
constexpr double kUsualSteps = 100;

// Steps this short are never impossible, however slow the robot is said to be.
constexpr double kAllowanceM = 0.15, kAllowanceRad = 0.15;

// Encoders that restart read zero, or what the robot drove since, within one scan.
constexpr double kRestartM = 0.1, kRestartRad = 0.1;
// A restart closer to its target than this changes nothing; and it is faster than anything before
// by this factor, unlike a robot that drives back to its start.
constexpr double kShortestRestartM = 0.15, kShortestRestartRad = 0.15;
constexpr double kRestartFactor = 2.0;
// Taken for usual before any motion was seen.
constexpr double kSlowSpeedMS = 0.3, kSlowTurnRadS = 0.5;

// Wheels that report more than this have moved: above the noise of digits, below a slow robot's
// step.
constexpr double kMovedM = 1e-3, kMovedRad = 1e-3;

bool Exceeds(const SE2& motion, double limit_m, double limit_rad) {
  return motion.translation().norm() > limit_m || std::abs(motion.theta) > limit_rad;
}

bool IsNear(const SE2& a, const SE2& b) {
  return !Exceeds(backend::Between(a, b), kRestartM, kRestartRad);
}

// Scans without any hit are equal wherever they are taken, and are no repetition.
bool IsRepeated(const std::vector<Beam>& before, const std::vector<Beam>& beams) {
  return std::ranges::equal(before, beams,
                            [](const Beam& a, const Beam& b) {
                              return a.range_m == b.range_m && a.status == b.status;
                            }) &&
         std::ranges::any_of(beams, [](const Beam& b) { return b.status == BeamStatus::kHit; });
}

}  // namespace

const char* OdometryFaultName(OdometryFault fault) { return NameOf(kFaults, fault); }

const char* OdometryFaultMessage(OdometryFault fault) {
  switch (fault) {
    case OdometryFault::kImpossible:
      return "the odometry makes a step that no robot makes";
    case OdometryFault::kRestart:
      return "the odometry jumps back to where it began, as encoders that restart do";
    case OdometryFault::kRepeatedScan:
      return "a scan repeats the one before bit for bit while the wheels move";
    case OdometryFault::kMissing:
      return "no odometry";
    case OdometryFault::kNone:
    case OdometryFault::kFirst:
    case OdometryFault::kUnchanged:
      break;
  }
  return "";
}

OdometryCheck::OdometryCheck(const Options& options)
    : options_(options),
      usual_speed_m_s_(std::min(kSlowSpeedMS, options.max_speed_m_s)),
      usual_turn_rad_s_(std::min(kSlowTurnRadS, options.max_turn_rad_s)) {
  CHECK_GT(options.max_speed_m_s, 0.0);
  CHECK_GT(options.max_turn_rad_s, 0.0);
}

OdometryCheck::Step OdometryCheck::Check(const LaserScan& scan) {
  Step step{{}, scan.has_odometry ? OdometryFault::kFirst : OdometryFault::kMissing};
  double elapsed_s = 0.0;
  if (previous_) {
    elapsed_s = ElapsedTime(scan.stamp_s);
    step = Judge(scan, elapsed_s, IsRepeated(previous_beams_, scan.beams));
  }
  Remember(scan, step, elapsed_s);
  return step;
}

OdometryCheck::Step OdometryCheck::Judge(const LaserScan& scan, double elapsed_s,
                                         bool repeated) const {
  if (!scan.has_odometry || !previous_->has_odometry) return {{}, OdometryFault::kMissing};
  if (scan.odom_T_robot == previous_->odom_T_robot) return {{}, OdometryFault::kUnchanged, SE2{}};
  const SE2 told = backend::Between(previous_->odom_T_robot, scan.odom_T_robot);
  if (!told.IsFinite()) return {{}, OdometryFault::kImpossible};
  const SE2 motion{way_factor_ * told.x, way_factor_ * told.y, told.theta};
  if (IsRestart(scan.odom_T_robot, motion, elapsed_s)) return {{}, OdometryFault::kRestart};
  if (Exceeds(motion, std::max(kAllowanceM, options_.max_speed_m_s * elapsed_s),
              std::max(kAllowanceRad, options_.max_turn_rad_s * elapsed_s))) {
    return {{}, OdometryFault::kImpossible, told};
  }
  if (repeated && Exceeds(motion, kMovedM, kMovedRad)) {
    return {motion, OdometryFault::kRepeatedScan, told};
  }
  return {motion, OdometryFault::kNone, told};
}

double OdometryCheck::ElapsedTime(double stamp_s) const {
  return std::max({stamp_s - previous_->stamp_s, usual_period_s_, kShortestPeriodS});
}

bool OdometryCheck::IsRestart(const SE2& odom_T_robot, const SE2& motion, double elapsed_s) const {
  if (!IsNear({}, odom_T_robot) &&
      !(first_odom_T_robot_ && IsNear(*first_odom_T_robot_, odom_T_robot))) {
    return false;
  }
  return Exceeds(motion, std::max(kShortestRestartM, kRestartFactor * usual_speed_m_s_ * elapsed_s),
                 std::max(kShortestRestartRad, kRestartFactor * usual_turn_rad_s_ * elapsed_s));
}

void OdometryCheck::Remember(const LaserScan& scan, const Step& step, double elapsed_s) {
  if (previous_) {
    const double period_s =
        std::clamp(scan.stamp_s - previous_->stamp_s, 0.0, kLongestUsualPeriodS);
    num_steps_ = std::min(num_steps_ + 1.0, kUsualSteps);
    usual_period_s_ += (period_s - usual_period_s_) / num_steps_;
  }
  if (step.fault == OdometryFault::kNone) {
    usual_speed_m_s_ = std::max(usual_speed_m_s_, step.motion.translation().norm() / elapsed_s);
    usual_turn_rad_s_ = std::max(usual_turn_rad_s_, std::abs(step.motion.theta) / elapsed_s);
  }
  if (!first_odom_T_robot_ && scan.has_odometry && scan.odom_T_robot.IsFinite()) {
    first_odom_T_robot_ = scan.odom_T_robot;
  }
  previous_ = {scan.stamp_s, scan.odom_T_robot, scan.has_odometry};
  previous_beams_ = scan.beams;
}

}  // namespace gmapping_spa::sensor
