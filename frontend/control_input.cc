// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/control_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::frontend {

using sensor::OdometryCheck;
using sensor::OdometryFault;

namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

}  // namespace

ControlInput::ControlInput(const Options& options, Health* health)
    : options_(options),
      health_(health),
      check_(options.check),
      lidar_odometry_(options.lidar_odometry) {}

ScanMotion ControlInput::AddScan(const sensor::LaserScan& scan) {
  OdometryCheck::Step wheels = check_.Check(scan);
  if (options_.source == OdometrySource::kLidarOnly) {
    if (wheels.fault != OdometryFault::kFirst) wheels = {{}, OdometryFault::kMissing};
  } else {
    ReportFault(wheels, scan.stamp_s);
  }
  ReportBlind(scan);
  if (options_.source == OdometrySource::kRaw) {
    if (stand_still_.IsContradicted(scan, wheels.fault == OdometryFault::kUnchanged)) {
      health_->Report("odometry_silent", scan.stamp_s,
                      "the odometry stands still while the scans change; it is used all the same");
    }
    return AsLogged(scan);
  }
  ScanMotion motion = lidar_odometry_.MatchScan(scan, wheels);
  LearnScale(wheels, motion, scan.stamp_s);
  ReportSweep(scan);
  if (options_.source == OdometrySource::kWheel) {
    if (motion.wheels_rejected || motion.wheels_silent) {
      health_->Report("odometry_contradicted", scan.stamp_s,
                      "the scan contradicts the odometry by more than its usual error; it is used "
                      "all the same");
    }
    ReportUnmatched(motion, wheels, scan.stamp_s);
    ScanMotion of_wheels;
    of_wheels.motion = wheels.motion;
    of_wheels.noise = motion.noise;
    of_wheels.velocity = motion.velocity;
    return of_wheels;
  }
  ReportCalibration(scan.stamp_s);
  ReportMatch(motion, wheels, scan.stamp_s);
  return motion;
}

// Over scans without odometry it is as if the robot had stood still.
ScanMotion ControlInput::AsLogged(const sensor::LaserScan& scan) {
  ScanMotion motion;
  if (!scan.has_odometry) return motion;
  if (odom_T_previous_) motion.motion = Between(*odom_T_previous_, scan.odom_T_robot);
  odom_T_previous_ = scan.odom_T_robot;
  return motion;
}

void ControlInput::LearnScale(const OdometryCheck::Step& wheels, const ScanMotion& motion,
                              double stamp_s) {
  if (!wheels.told || !motion.matched || !motion.alternatives.empty()) {
    odometry_scale_.Skip();
    return;
  }
  if (!odometry_scale_.Add(*wheels.told, motion.motion)) return;
  const double factor = odometry_scale_.factor();
  check_.set_way_factor(factor);
  const std::string unit = odometry_scale_.unit();
  health_->Report("odometry_scaled", stamp_s,
                  "the odometry tells ways " + backend::FixedText(1.0 / factor, 2) +
                      " times as long as the scans show" +
                      (unit.empty() ? "" : ", as in " + unit + " instead of meters") +
                      "; that is corrected from here on");
}

void ControlInput::ReportFault(const OdometryCheck::Step& wheels, double stamp_s) {
  const std::string message = OdometryFaultMessage(wheels.fault);
  if (message.empty()) return;
  const bool raw = options_.source == OdometrySource::kRaw;
  const char* consequence = raw ? "it is used all the same" : "the step is left out";
  if (wheels.fault == OdometryFault::kRepeatedScan && !raw) consequence = "it is not matched";
  if (wheels.fault == OdometryFault::kMissing) {
    consequence = raw ? "its motion comes with the next one" : "scans alone tell the motion";
  }
  health_->Report(OdometryFaultName(wheels.fault), stamp_s, message + "; " + consequence);
}

// Once anything has been hit: a log without any hit is an error, and that is enough.
void ControlInput::ReportBlind(const sensor::LaserScan& scan) {
  if (std::none_of(scan.beams.begin(), scan.beams.end(), [](const sensor::Beam& beam) {
        return beam.status == sensor::BeamStatus::kHit;
      })) {
    blind_stamps_s_.push_back(scan.stamp_s);
  } else {
    has_seen_ = true;
  }
  if (!has_seen_) return;
  for (const double stamp_s : blind_stamps_s_) {
    health_->Report(
        "blind_scan", stamp_s,
        "no beam of a scan hits anything: the laser is covered, or nothing is in range");
  }
  blind_stamps_s_.clear();
}

// Once, and once more where the log is wrong about it, or it was no sweep.
void ControlInput::ReportSweep(const sensor::LaserScan& scan) {
  if (options_.lidar_odometry.sweep_duration_s) return;
  if (sweep_s() == 0.0) {
    if (has_reported_sweep_) {
      health_->Report("sweep_given_up", scan.stamp_s,
                      "scans no longer bend while the robot turns as they seemed to: they are not "
                      "deskewed from here on, none of them in the end");
    }
    has_reported_sweep_ = false;
    return;
  }
  const auto milliseconds = [](double duration_s) {
    return std::to_string(std::lround(1e3 * std::abs(duration_s))) + " ms";
  };
  const std::string seen =
      "scans bend while the robot turns, as those of a laser that takes about " +
      milliseconds(sweep_s()) + " for a scan" + (sweep_s() < 0.0 ? ", the last beam first" : "");
  const std::string consequence = "; scans are deskewed from here on, all of them in the end";
  const bool contradicts = lidar_odometry_.sweep_contradicts_log();
  if (contradicts && !has_contradicted_sweep_) {
    health_->Report(
        "sweep_contradicted", scan.stamp_s,
        seen + ", not " + milliseconds(scan.sweep_s) + " as the log tells" + consequence);
  } else if (!has_reported_sweep_) {
    health_->Report("scans_deskewed", scan.stamp_s,
                    (scan.sweep_s > 0.0 ? "the log tells that the laser takes " +
                                              milliseconds(scan.sweep_s) + " for a scan"
                                        : seen) +
                        consequence);
  }
  has_contradicted_sweep_ = has_contradicted_sweep_ || contradicts;
  has_reported_sweep_ = true;
}

// Once, when the numbers are more than rounding.
void ControlInput::ReportCalibration(double stamp_s) {
  const WheelCalibration& calibration = lidar_odometry_.wheel_calibration();
  const double deg_per_m = kDegPerRad * calibration.rad_per_m();
  const double percent = 100.0 * calibration.rad_per_rad();
  if (has_reported_calibration_ || (std::abs(deg_per_m) < 0.1 && std::abs(percent) < 0.5)) return;
  has_reported_calibration_ = true;
  health_->Report("odometry_calibrated", stamp_s,
                  "the odometry turns wrong all the time, by about " +
                      backend::FixedText(-deg_per_m, 1) + " deg per m driven and " +
                      backend::FixedText(-percent, 1) +
                      " % of its turns so far; that is corrected, and learned on, from here on");
}

void ControlInput::ReportUnmatched(const ScanMotion& motion, const OdometryCheck::Step& wheels,
                                   double stamp_s) {
  if (motion.matched || wheels.fault == OdometryFault::kRepeatedScan) return;
  health_->Report("unmatched_scan", stamp_s, "a scan does not fit what was seen before");
  health_->Mark("lost", stamp_s);
}

void ControlInput::ReportMatch(const ScanMotion& motion, const OdometryCheck::Step& wheels,
                               double stamp_s) {
  if (motion.wheels_silent) {
    health_->Report("odometry_silent", stamp_s,
                    "the odometry stands still while the scans show motion; it is left out");
  }
  if (motion.wheels_turn_only) {
    health_->Report("odometry_turns_only", stamp_s,
                    "the odometry has told turns, but never a way, while the scans show one; its "
                    "turns are used alone");
  }
  if (motion.wheels_late) {
    health_->Report("odometry_late", stamp_s,
                    "the odometry tells motions later than the scans; it is used with its delay");
  }
  if (motion.wheels_mirrored) {
    health_->Report("odometry_mirrored", stamp_s,
                    "the odometry turns the other way than the scans: either the laser is mounted "
                    "upside down, and the map is mirrored (--laser_flipped), or the odometry's "
                    "angle has the wrong sign");
  }
  if (motion.wheels_rejected && wheels.fault == OdometryFault::kNone) {
    health_->Report("odometry_contradicted", stamp_s,
                    "the scan contradicts the odometry by more than its usual error");
  }
  if (motion.unobserved) {
    health_->Report(
        "motion_unobserved", stamp_s,
        "neither the scans nor the odometry tell how far the robot goes, as in a corridor; "
        "it is taken to go on as before");
    health_->Mark("ambiguous", stamp_s);
  }
  if (unchecked_way_.Add(motion.motion.translation().norm(), motion.unchecked)) {
    health_->Report("odometry_unchecked", stamp_s,
                    "for most of 10 m the scans fit as well farther on or farther back, as in a "
                    "corridor: how far the robot went is what the odometry says, right or wrong");
  }
  if (!motion.alternatives.empty()) {
    health_->Report("ambiguous_scan", stamp_s,
                    "a scan fits in " + std::to_string(motion.alternatives.size()) +
                        " places; the particles share them out");
    health_->Mark("ambiguous", stamp_s);
  }
  ReportUnmatched(motion, wheels, stamp_s);
  if (motion.new_piece_scans > 0) {
    health_->Report("new_piece", stamp_s,
                    "the scans do not fit what was seen before, but each other: lost; going on in "
                    "a new piece of map until a loop closure joins it");
  }
}

}  // namespace gmapping_spa::frontend
