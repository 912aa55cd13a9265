// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/trajectory_io.h"

#include <cmath>
#include <stdexcept>

#include "backend/graph/number_rows.h"
#include "backend/graph/planar_quaternion.h"
#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

// Hand-made files round quaternions to three digits or so. What is further from unit norm is
// another format or a wrong order of columns.
constexpr double kUnitNormTolerance = 0.01;

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
    trajectory.push_back({v[0], {v[1], v[2], YawOf(qx, qy, qz, qw)}});
  }
  return trajectory;
}

void WriteTum(const Trajectory& trajectory, std::ostream& out) {
  for (const auto& [stamp_s, world_T_robot] : trajectory) {
    if (!std::isfinite(stamp_s) || !world_T_robot.IsFinite()) {
      throw std::invalid_argument("WriteTum: a trajectory must be finite");
    }
    const PlanarQuaternion q = QuaternionOf(WrapAngle(world_T_robot.theta));
    out << ShortestFixedText(stamp_s) << ' ' << ShortestText(world_T_robot.x) << ' '
        << ShortestText(world_T_robot.y) << " 0 0 0 " << ShortestText(q.qz) << ' '
        << ShortestText(q.qw) << '\n';
  }
}

}  // namespace gmapping_spa::backend
