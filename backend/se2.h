// SPDX-License-Identifier: BSD-3-Clause
// SE(2), the group of rigid motions in the plane.
//
// Frames are named as in world_T_robot: it maps coordinates in `robot` to coordinates in `world`,
// so that world_T_robot * robot_T_laser == world_T_laser. Metres and radians throughout.
#ifndef GMAPPING_SPA_BACKEND_SE2_H_
#define GMAPPING_SPA_BACKEND_SE2_H_

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace gmapping_spa::backend {

// Returns the angle equivalent to `theta` in [-pi, pi]. NaN and infinity give NaN.
inline double WrapAngle(double theta) {
  // Most angles are in range already, where the remainder is the angle itself.
  if (std::abs(theta) < std::numbers::pi) return theta;
  return std::remainder(theta, 2.0 * std::numbers::pi);
}

// A pose or rigid motion: rotation by theta, then translation by (x, y). Plain data, so that it can
// cross the boundary of a plugin.
struct SE2 {
  double x = 0.0;      // m
  double y = 0.0;      // m
  double theta = 0.0;  // rad

  Eigen::Vector2d translation() const { return {x, y}; }
  bool IsFinite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(theta); }
  friend bool operator==(const SE2&, const SE2&) = default;
};

// Composition a_T_b * b_T_c = a_T_c; the angle of the result is wrapped.
inline SE2 operator*(const SE2& a_T_b, const SE2& b_T_c) {
  const double c = std::cos(a_T_b.theta), s = std::sin(a_T_b.theta);
  return {a_T_b.x + c * b_T_c.x - s * b_T_c.y, a_T_b.y + s * b_T_c.x + c * b_T_c.y,
          WrapAngle(a_T_b.theta + b_T_c.theta)};
}

// Maps a point given in frame b into frame a.
inline Eigen::Vector2d operator*(const SE2& a_T_b, const Eigen::Vector2d& b_point) {
  const double c = std::cos(a_T_b.theta), s = std::sin(a_T_b.theta);
  return {a_T_b.x + c * b_point.x() - s * b_point.y(), a_T_b.y + s * b_point.x() + c * b_point.y()};
}

inline SE2 Inverse(const SE2& a_T_b) {
  const double c = std::cos(a_T_b.theta), s = std::sin(a_T_b.theta);
  return {-c * a_T_b.x - s * a_T_b.y, s * a_T_b.x - c * a_T_b.y, WrapAngle(-a_T_b.theta)};
}

// Relative pose a_T_b of two poses given in one frame: Inverse(w_T_a) * w_T_b, without the loss of
// digits that large coordinates would cause.
inline SE2 Between(const SE2& w_T_a, const SE2& w_T_b) {
  const double c = std::cos(w_T_a.theta), s = std::sin(w_T_a.theta);
  const double dx = w_T_b.x - w_T_a.x, dy = w_T_b.y - w_T_a.y;
  return {c * dx + s * dy, -s * dx + c * dy, WrapAngle(w_T_b.theta - w_T_a.theta)};
}

// The pose with `delta` added to its coordinates (x, y, theta), and back: Plus(from, Minus(to,
// from)) is `to`. Not composition: x and y are changed along the axes of the frame that the pose is
// given in, as optimizers and covariances in that frame have it. Angles are wrapped.
inline SE2 Plus(const SE2& pose, const Eigen::Vector3d& delta) {
  return {pose.x + delta.x(), pose.y + delta.y(), WrapAngle(pose.theta + delta.z())};
}
inline Eigen::Vector3d Minus(const SE2& to, const SE2& from) {
  return {to.x - from.x, to.y - from.y, WrapAngle(to.theta - from.theta)};
}

// Exponential map: the motion reached after unit time at constant body velocity (vx, vy, omega).
inline SE2 Exp(const Eigen::Vector3d& twist) {
  const double w = twist.z();
  // sin(w)/w and (1-cos(w))/w, by their series where the quotients lose digits.
  const bool small = std::abs(w) < 1e-4;
  const double a = small ? 1.0 - w * w / 6.0 : std::sin(w) / w;
  const double b = small ? w / 2.0 - w * w * w / 24.0 : (1.0 - std::cos(w)) / w;
  return {a * twist.x() - b * twist.y(), b * twist.x() + a * twist.y(), WrapAngle(w)};
}

// Inverse of Exp; the rotation is taken in [-pi, pi].
inline Eigen::Vector3d Log(const SE2& pose) {
  const double w = WrapAngle(pose.theta);
  const double half = w / 2.0;
  // half * cot(half); its series near zero.
  const double a = std::abs(w) < 1e-4 ? 1.0 - w * w / 12.0 : half / std::tan(half);
  return {a * pose.x + half * pose.y, -half * pose.x + a * pose.y, w};
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SE2_H_
