// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/trajectory_io.h"

#include <cmath>
#include <stdexcept>

#include "backend/graph/number_rows.h"
#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

// Hand-made files round quaternions to three digits or so. What is further from unit norm is
// another format or a wrong order of columns.
constexpr double kUnitNormTolerance = 0.01;

double YawOfPlanarQuaternion(double qz, double qw) { return WrapAngle(2.0 * std::atan2(qz, qw)); }

// Yaw of roll, pitch and yaw (rotation about z after y after x).
double Yaw(double qx, double qy, double qz, double qw) {
  // The general formula squares and so loses half of the digits of a small angle.
  if (qx == 0.0 && qy == 0.0) return YawOfPlanarQuaternion(qz, qw);
  return std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

double StepUlps(double value, int steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, 2.0);
  for (; steps < 0; ++steps) value = std::nextafter(value, -2.0);
  return value;
}

struct PlanarQuaternion {
  double qz = 0.0;
  double qw = 1.0;
};

// The quaternion from which Yaw gets back exactly `theta`. Sine and cosine are rounded, so that the
// angle of the nearest doubles may be off by one in its last digit; a close neighbor has it.
PlanarQuaternion FromYaw(double theta) {
  constexpr int kMaxUlps = 3;
  const PlanarQuaternion nearest = {std::sin(theta / 2.0), std::cos(theta / 2.0)};
  for (int distance = 0; distance <= kMaxUlps; ++distance) {
    for (int dz = -distance; dz <= distance; ++dz) {
      for (int dw = -distance; dw <= distance; ++dw) {
        const PlanarQuaternion q = {StepUlps(nearest.qz, dz), StepUlps(nearest.qw, dw)};
        if (YawOfPlanarQuaternion(q.qz, q.qw) == theta) return q;
      }
    }
  }
  return nearest;
}

}  // namespace

Trajectory ReadTum(std::istream& in, const std::string& name) {
  NumberRows rows(in, name, "stamp x y z qx qy qz qw");
  Trajectory trajectory;
  while (rows.Next()) {
    const std::vector<double>& v = rows.row();
    const double qx = v[4], qy = v[5], qz = v[6], qw = v[7];
    const double norm = std::sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
    // Written so that an infinite norm fails, too.
    if (!(std::abs(norm - 1.0) <= kUnitNormTolerance)) {
      rows.Fail("a quaternion of norm 1", "one of norm " + std::to_string(norm));
    }
    trajectory.push_back({v[0], {v[1], v[2], Yaw(qx, qy, qz, qw)}});
  }
  return trajectory;
}

void WriteTum(const Trajectory& trajectory, std::ostream& out) {
  for (const auto& [stamp_s, world_T_robot] : trajectory) {
    if (!std::isfinite(stamp_s) || !world_T_robot.IsFinite()) {
      throw std::invalid_argument("WriteTum: a trajectory must be finite");
    }
    const PlanarQuaternion q = FromYaw(WrapAngle(world_T_robot.theta));
    out << ShortestFixedText(stamp_s) << ' ' << ShortestText(world_T_robot.x) << ' '
        << ShortestText(world_T_robot.y) << " 0 0 0 " << ShortestText(q.qz) << ' '
        << ShortestText(q.qw) << '\n';
  }
}

}  // namespace gmapping_spa::backend
