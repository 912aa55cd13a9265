// SPDX-License-Identifier: BSD-3-Clause
// Wheels are checked, not believed: tells the motion between two scans, or why it is not known.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_ODOMETRY_CHECK_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_ODOMETRY_CHECK_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::sensor {

enum class OdometryFault : std::uint8_t {
  kNone,
  kFirst,       // the first scan: no motion to tell
  kImpossible,  // a step no robot makes, or a reading that is not finite
  kRestart,     // a sudden step to (nearly) zero or to the log's first reading: encoders restarted
  kUnchanged,   // the reading before, bit for bit: at rest, or silent; scans decide
  kRepeatedScan,  // the ranges before, bit for bit, while the wheels moved: the scan is of no use
  kMissing        // the log holds no odometry for this scan or the one before
};

// Its name in records: "none", "first", "unchanged" or the key of a finding, "odometry_impossible",
// "odometry_restart", "repeated_scan", "odometry_missing".
const char* OdometryFaultName(OdometryFault fault);

// One line for people; empty where there is nothing to report: kNone, kFirst, kUnchanged.
const char* OdometryFaultMessage(OdometryFault fault);

// Takes the scans of a log in order. Every step is judged by the reading before it alone, so that
// after a fault the next good reading counts again.
class OdometryCheck {
 public:
  // What a robot can do; both positive. A step is impossible when it is longer than that over the
  // time between the scans. Stamps that jitter, repeat or run backward do not make a step
  // impossible: the time counts as no shorter than the usual one between scans, nor than 0.1 s.
  struct Options {
    double max_speed_m_s = 5.0;
    double max_turn_rad_s = 6.0;
    friend bool operator==(const Options&, const Options&) = default;
  };

  struct Step {
    // Of the robot since the scan before, in its frame there. The identity where the fault says
    // that nothing is known: kFirst, kImpossible, kRestart, kMissing.
    backend::SE2 motion;
    OdometryFault fault = OdometryFault::kNone;
    // The same as the log tells it, possible or not; nothing where it does not, or at a restart.
    std::optional<backend::SE2> told = std::nullopt;
  };

  explicit OdometryCheck(const Options& options);

  Step Check(const LaserScan& scan);

  // Ways of the odometry are multiplied by it before they are judged.
  void set_way_factor(double factor) { way_factor_ = factor; }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(previous_, first_odom_T_robot_, previous_beams_, usual_period_s_, num_steps_,
            usual_speed_m_s_, usual_turn_rad_s_, way_factor_);
  }

 private:
  // What a reading, and the time, is compared with.
  struct Reading {
    double stamp_s;
    backend::SE2 odom_T_robot;
    bool has_odometry;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(stamp_s, odom_T_robot, has_odometry);
    }
  };

  Step Judge(const LaserScan& scan, double elapsed_s, bool repeated) const;
  // The time since the scan before, as far as stamps can be trusted.
  double ElapsedTime(double stamp_s) const;
  // Whether a step to (nearly) zero or the first reading is faster than what was seen so far.
  bool IsRestart(const backend::SE2& odom_T_robot, const backend::SE2& motion,
                 double elapsed_s) const;
  void Remember(const LaserScan& scan, const Step& step, double elapsed_s);

  Options options_;
  std::optional<Reading> previous_;
  std::optional<backend::SE2> first_odom_T_robot_;
  std::vector<Beam> previous_beams_;
  double usual_period_s_ = 0.0;  // mean of the last steps of time
  double num_steps_ = 0.0;       // of time in that mean
  double usual_speed_m_s_;       // the fastest that was possible so far
  double usual_turn_rad_s_;
  double way_factor_ = 1.0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_ODOMETRY_CHECK_H_
