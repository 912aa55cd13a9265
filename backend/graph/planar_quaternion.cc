// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/planar_quaternion.h"

#include <cmath>

#include "backend/se2.h"

namespace gmapping_spa::backend {
namespace {

double YawOfPlanarQuaternion(double qz, double qw) { return WrapAngle(2.0 * std::atan2(qz, qw)); }

double StepUlps(double value, int steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, 2.0);
  for (; steps < 0; ++steps) value = std::nextafter(value, -2.0);
  return value;
}

}  // namespace

double YawOf(double qx, double qy, double qz, double qw) {
  // The general formula squares and so loses half of the digits of a small angle.
  if (qx == 0.0 && qy == 0.0) return YawOfPlanarQuaternion(qz, qw);
  return std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

PlanarQuaternion QuaternionOf(double theta) {
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

}  // namespace gmapping_spa::backend
