// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/edge_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gmapping_spa::backend {
namespace {

// s - sin(s) and 1 - cos(s) without cancellation.
double SineDefect(double s) {
  if (std::abs(s) > 0.05) return s - std::sin(s);
  const double square = s * s;
  return s * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0));
}
double CosineDefect(double s) {
  const double half = std::sin(s / 2.0);
  return 2.0 * half * half;
}

// See EdgeBound. The curvature is that of twice the bound.
double LargestCurvature(double w, double torque, double d0) {
  const double p = 2.0 * std::abs(torque);
  const double largest = std::numbers::pi + std::copysign(d0, torque * d0);
  const double s = w > 0.0 ? std::min(p / w, largest) : largest;
  if (s < 1e-8) return 2.0 * w - p * s;
  const double denominator = CosineDefect(s);
  if (s > 6.0 && denominator < 1e-12) return -std::numeric_limits<double>::infinity();
  const double falling = w * s * s / denominator, rising = p * SineDefect(s) / denominator;
  return falling - rising - 1e-13 * (falling + rising);
}

}  // namespace

EdgeBound BoundEdge(const Edge& edge, const InformationSplit& split, const SE2& i_T_j_at_poses,
                    const Eigen::Vector3d& tangent) {
  const Eigen::Vector3d error = Minus(i_T_j_at_poses, edge.i_T_j);
  const Eigen::Vector3d gradient = edge.information * tangent;
  const double tau = split.translation, w = split.rotation, torque = gradient.z();
  const Complex measured(edge.i_T_j.x, edge.i_T_j.y), at_poses(i_T_j_at_poses.x, i_T_j_at_poses.y);
  const Complex tangent_m(tangent.x(), tangent.y()), force(gradient.x(), gradient.y());
  // Not wrapped: the bound is one for angles in [-pi, pi].
  const Eigen::Vector3d change_vector = error - tangent;
  const Complex change(change_vector.x(), change_vector.y());
  const double delta = change_vector.z();
  const double curvature = LargestCurvature(w, torque, tangent.z());

  EdgeBound bound;
  bound.tau = tau;
  bound.b = tau * (measured + tangent_m) - force;
  bound.h = std::polar(0.5, -edge.i_T_j.theta - tangent.z()) * Complex(-curvature, -2.0 * torque);
  bound.force = force + tau * change;
  const double turn = 0.5 * curvature * std::sin(delta) + torque * std::cos(delta);
  bound.torque_i = -turn - std::imag(force * std::conj(measured + tangent_m)) -
                   std::imag(change * std::conj(bound.b));
  bound.torque_j = turn;
  bound.stiffness_j = 0.5 * curvature * std::cos(delta) - torque * std::sin(delta);
  bound.stiffness_i = bound.stiffness_j + std::real(at_poses * std::conj(bound.b));
  // The change of the error in the information that the tangent replaces, and that of the angle.
  const double rest = change_vector.dot(edge.information * change_vector) -
                      tau * std::norm(change) - w * delta * delta;
  const double angle =
      w * delta * delta + 2.0 * torque * SineDefect(delta) - curvature * CosineDefect(delta);
  bound.slack = 0.5 * (std::max(0.0, rest) + std::max(0.0, angle));
  return bound;
}

}  // namespace gmapping_spa::backend
