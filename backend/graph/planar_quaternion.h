// SPDX-License-Identifier: BSD-3-Clause
// Angles as the quaternions that file formats want.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_PLANAR_QUATERNION_H_
#define GMAPPING_SPA_BACKEND_GRAPH_PLANAR_QUATERNION_H_

namespace gmapping_spa::backend {

// A rotation about the z axis.
struct PlanarQuaternion {
  double qz = 0.0;
  double qw = 1.0;
};

// Yaw of roll, pitch and yaw (rotation about z after y after x), in [-pi, pi].
double YawOf(double qx, double qy, double qz, double qw);

// The quaternion from which YawOf gets back exactly `theta`, in [-pi, pi]. Sine and cosine are
// rounded, so that the angle of the nearest doubles may be off by one in its last digit; a close
// neighbor has it.
PlanarQuaternion QuaternionOf(double theta);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_PLANAR_QUATERNION_H_
