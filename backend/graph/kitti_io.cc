// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/kitti_io.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "backend/graph/number_rows.h"
#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

constexpr double kRotationTolerance = 0.01;
constexpr double kLeastVertical = 0.7071;  // of the z axis: cos of 45 degrees

using Rotation = Eigen::Matrix3d;

void CheckRotation(const NumberRows& rows, const Rotation& rotation) {
  const double deviation =
      (rotation * rotation.transpose() - Rotation::Identity()).cwiseAbs().maxCoeff();
  // Written so that what is infinite fails, too.
  if (!(deviation <= kRotationTolerance) || rotation.determinant() < 0.0) {
    rows.Fail("a rotation matrix in columns 1-3, 5-7 and 9-11", "one that is none");
  }
  if (rotation(2, 2) < kLeastVertical) {
    rows.Fail("a z axis that points up (a robot in the plane, not a camera)",
              "one whose vertical part is " + FixedText(rotation(2, 2), 3));
  }
}

}  // namespace

std::vector<SE2> ReadKitti(std::istream& in, const std::string& name) {
  NumberRows rows(in, name, "r11 r12 r13 x r21 r22 r23 y r31 r32 r33 z");
  std::vector<SE2> poses;
  while (rows.Next()) {
    using Matrix = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
    const Eigen::Map<const Matrix> matrix(rows.row().data());
    CheckRotation(rows, matrix.leftCols<3>());
    poses.push_back({matrix(0, 3), matrix(1, 3), std::atan2(matrix(1, 0), matrix(0, 0))});
  }
  return poses;
}

void WriteKitti(const Trajectory& trajectory, std::ostream& out) {
  for (const auto& [stamp_s, pose] : trajectory) {
    if (!pose.IsFinite()) throw std::invalid_argument("WriteKitti: a trajectory must be finite");
    const std::string cosine = ShortestText(std::cos(pose.theta));
    const double sine = std::sin(pose.theta);
    out << cosine << ' ' << ShortestText(0.0 - sine) << " 0 " << ShortestText(pose.x) << ' '
        << ShortestText(sine) << ' ' << cosine << " 0 " << ShortestText(pose.y) << " 0 0 1 0\n";
  }
}

void WriteTimes(const Trajectory& trajectory, std::ostream& out) {
  for (const StampedPose& pose : trajectory) {
    if (!std::isfinite(pose.stamp_s)) {
      throw std::invalid_argument("WriteTimes: stamps must be finite");
    }
    out << ShortestFixedText(pose.stamp_s) << '\n';
  }
}

}  // namespace gmapping_spa::backend
