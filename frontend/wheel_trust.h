// SPDX-License-Identifier: BSD-3-Clause
// How far the wheels are to be believed, learned from how well they predict the scans.
#ifndef GMAPPING_SPA_FRONTEND_WHEEL_TRUST_H_
#define GMAPPING_SPA_FRONTEND_WHEEL_TRUST_H_

#include <optional>

#include "backend/se2.h"
#include "frontend/motion_prior.h"
#include "frontend/sensor/odometry_check.h"
#include "frontend/wheel_calibration.h"

namespace gmapping_spa::frontend {

// Call Guess and Learn once a scan, in turn.
class WheelTrust {
 public:
  // What the wheels say about the motion since the scan before. Nothing where they are faulty,
  // missing, or silent: they have never moved, stand still while scans show motion, or would have
  // stopped sooner than a robot can. The way of wheels that have never told one is that of
  // `same_velocity`, the motion of a robot that goes on as before. `duration_s`: of the step.
  std::optional<WheelMotion> Guess(const sensor::OdometryCheck::Step& wheels,
                                   const backend::SE2& same_velocity, double duration_s);

  // `motion`: what it was, after all. `guess`: the hypothesis made of Guess. `tells_position`:
  // whether the scan surely tells how far the robot has gone.
  void Learn(const backend::SE2& motion, const MotionHypothesis& guess, bool tells_position);
  // The same where Guess had nothing to say.
  void Learn(const backend::SE2& motion);

  // Whether readings come later than the scans that they belong to.
  bool late() const {
    return step_error_.all() > kPoorError && late_error_.all() < kLateBelow * step_error_.all();
  }
  bool silent() const { return silent_; }
  // By which their turns are corrected.
  const WheelCalibration& calibration() const { return calibration_; }
  // Whether they have told turns, but never a way.
  bool tells_turns_only() const { return ever_moved_ && !ever_told_way_; }
  // Whether wheels and scans have turned opposite ways over some whole turns: one of them is
  // mirrored.
  bool mirrored() const {
    return turned_rad_ > kTurnedToJudge_rad && opposite_rad_ > kOpposite * turned_rad_;
  }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(calibration_, raw_step_, step_, unchanged_, ever_moved_, ever_told_way_, silent_,
            contradicted_while_unchanged_, owed_, step_error_, late_error_, block_error_m_,
            block_error_rad_, blocks_, block_wheels_, block_motion_, block_variance_m2_,
            block_variance_rad2_, block_scans_, wrong_, turned_rad_, opposite_rad_);
  }

 private:
  static constexpr double kPoorError = 3.0;  // below it, they do as they are
  static constexpr double kLateBelow = 0.5;
  static constexpr double kTurnedToJudge_rad = 6.0;
  static constexpr double kOpposite = 0.8;

  // Running means of squared errors, in units of the variance expected of the wheels. Wheels that
  // slip as they turn may tell the way as well as ever.
  struct StepError {
    double m = 1.0;
    double rad = 1.0;
    double all() const { return (2.0 * m + rad) / 3.0; }  // of three dimensions
    void Learn(const MotionHypothesis& expected, const backend::SE2& motion);
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(m, rad);
    }
  };

  backend::SE2 Owed() const { return owed_ * step_; }
  void LearnBlock(const backend::SE2& motion, const MotionHypothesis& plain, bool tells_position);

  WheelCalibration calibration_;
  backend::SE2 raw_step_;  // of the wheels at this scan
  backend::SE2 step_;      // corrected
  bool unchanged_ = false;
  bool ever_moved_ = false;
  bool ever_told_way_ = false;
  bool silent_ = false;
  int contradicted_while_unchanged_ = 0;  // scans in a row
  // What the wheels have reported on the last scans and the robot has not done, or the other way
  // round: of wheels whose readings come late, it is what they still owe.
  backend::SE2 owed_;
  StepError step_error_;
  StepError late_error_;  // of their steps with what is owed
  // The same of their motion over a block of scans, by direction: the noise of scan matching does
  // not add up there, so that it shows wheels that are better than expected.
  double block_error_m_ = 1.0;
  double block_error_rad_ = 1.0;
  int blocks_ = 0;
  // Of the block at hand.
  backend::SE2 block_wheels_, block_motion_;
  double block_variance_m2_ = 0.0, block_variance_rad2_ = 0.0;
  int block_scans_ = 0;  // in which the wheels moved
  double wrong_ = 0.01;  // share of the scans that contradict the wheels
  // Of all steps in which both turned: by how much, and in how much of it the opposite ways.
  double turned_rad_ = 0.0;
  double opposite_rad_ = 0.0;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_WHEEL_TRUST_H_
