// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/trajectory_error.h"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "experiments/metrics/angles.h"

namespace gmapping_spa::metrics {
namespace {

using backend::SE2;

PoseErrorSummary Summarize(const std::vector<SE2>& errors) {
  std::vector<double> translations_m, rotations_deg;
  for (const SE2& error : errors) {
    translations_m.push_back(error.translation().norm());
    rotations_deg.push_back(AbsDegrees(error.theta));
  }
  return {.pairs = static_cast<int>(errors.size()),
          .translation_m = ComputeStatistics(translations_m),
          .rotation_deg = ComputeStatistics(rotations_deg)};
}

// Umeyama's alignment in the plane, where the rotation has a closed form: the angle of the sum of
// conj(estimate) * truth, positions from their means taken as complex numbers.
SE2 LeastSquaresAlignment(const std::vector<PosePair>& pairs) {
  Eigen::Vector2d truth_mean = Eigen::Vector2d::Zero(), estimate_mean = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    truth_mean += pair.truth_T_robot.translation() / pairs.size();
    estimate_mean += pair.estimate_T_robot.translation() / pairs.size();
  }
  double dot = 0.0, cross = 0.0, scale = 0.0;
  double cos_turned = 0.0, sin_turned = 0.0;  // of the headings
  for (const PosePair& pair : pairs) {
    const Eigen::Vector2d t = pair.truth_T_robot.translation() - truth_mean;
    const Eigen::Vector2d e = pair.estimate_T_robot.translation() - estimate_mean;
    dot += e.dot(t);
    cross += e.x() * t.y() - e.y() * t.x();
    scale += pair.truth_T_robot.translation().norm() * pair.estimate_T_robot.translation().norm();
    const double turned_rad = pair.truth_T_robot.theta - pair.estimate_T_robot.theta;
    cos_turned += std::cos(turned_rad);
    sin_turned += std::sin(turned_rad);
  }
  // What rounding leaves of a robot that stands still is not a direction: there the error of the
  // positions is the same for any rotation.
  const bool positions_tell = std::hypot(dot, cross) > 1e-14 * scale;
  const double theta = positions_tell ? std::atan2(cross, dot) : std::atan2(sin_turned, cos_turned);
  const Eigen::Vector2d translation = truth_mean - SE2{0.0, 0.0, theta} * estimate_mean;
  return {translation.x(), translation.y(), theta};
}

// The poses between which relative errors are taken: the ends of the steps.
std::vector<std::size_t> EndsOfSteps(const std::vector<PosePair>& pairs,
                                     const RelativePoseErrorOptions& options) {
  // Stamps are often rounded to microseconds: ten steps of 0.1 s shall make a second.
  constexpr double kStampResolution_s = 1e-6;
  std::vector<std::size_t> ends;
  double path_m = 0.0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    bool is_end = false;
    switch (options.unit) {
      case StepUnit::kFrames:
        is_end = ends.empty() || static_cast<double>(k - ends.back()) >= options.step;
        break;
      case StepUnit::kSeconds:
        is_end = ends.empty() ||
                 pairs[k].stamp_s - pairs[ends.back()].stamp_s >= options.step - kStampResolution_s;
        break;
      case StepUnit::kMetres:
        if (k > 0) {
          path_m += (pairs[k].estimate_T_robot.translation() -
                     pairs[k - 1].estimate_T_robot.translation())
                        .norm();
        }
        is_end = path_m >= options.step;
        if (is_end) path_m = 0.0;
        break;
    }
    if (is_end) ends.push_back(k);
  }
  return ends;
}

}  // namespace

SE2 Align(const std::vector<PosePair>& pairs, Alignment alignment) {
  if (pairs.empty()) throw std::runtime_error("no pose could be associated by its stamp");
  switch (alignment) {
    case Alignment::kNone:
      return SE2{};
    case Alignment::kFirst:
      return pairs[0].truth_T_robot * Inverse(pairs[0].estimate_T_robot);
    case Alignment::kSe2:
      return LeastSquaresAlignment(pairs);
  }
  throw std::invalid_argument("unknown alignment");
}

PoseErrorSummary AbsoluteTrajectoryError(const std::vector<PosePair>& pairs, Alignment alignment) {
  const SE2 truth_T_estimate = Align(pairs, alignment);
  std::vector<SE2> errors;
  errors.reserve(pairs.size());
  for (const PosePair& pair : pairs) {
    errors.push_back(Between(pair.truth_T_robot, truth_T_estimate * pair.estimate_T_robot));
  }
  return Summarize(errors);
}

PoseErrorSummary RelativePoseError(const std::vector<PosePair>& pairs,
                                   const RelativePoseErrorOptions& options) {
  if (!(options.step > 0.0) || !std::isfinite(options.step) ||
      (options.unit == StepUnit::kFrames && options.step != std::floor(options.step))) {
    throw std::invalid_argument(
        "the step of the relative pose error must be positive, and whole "
        "if it is a number of frames");
  }
  const std::vector<std::size_t> ends = EndsOfSteps(pairs, options);
  std::vector<SE2> errors;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const PosePair& i = pairs[ends[k - 1]];
    const PosePair& j = pairs[ends[k]];
    errors.push_back(Between(Between(i.truth_T_robot, j.truth_T_robot),
                             Between(i.estimate_T_robot, j.estimate_T_robot)));
  }
  if (errors.empty()) {
    throw std::runtime_error("no step of the relative pose error fits into the trajectory");
  }
  return Summarize(errors);
}

}  // namespace gmapping_spa::metrics
