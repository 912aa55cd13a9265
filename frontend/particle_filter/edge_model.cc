// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/edge_model.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::particle_filter {

EdgeModel::EdgeModel(const Options& options)
    : options_(options), gauss_newton_(options.gauss_newton) {
  CHECK_GT(options.constant_sigma_m, 0.0);
  CHECK_GT(options.constant_sigma_rad, 0.0);
}

TrajectoryTree::Motion EdgeModel::Measure(const Step& step, const map::OccupancyGrid& map,
                                          const scan_matching::ScanPoints& points) const {
  const bool control = options_.measurement == Measurement::kControl;
  // From the axes of the world to those of the node that the edge starts at.
  Eigen::Matrix3d world_R_previous = Eigen::Matrix3d::Identity();
  world_R_previous.topLeftCorner<2, 2>() =
      Eigen::Rotation2Dd(step.world_T_previous.theta).toRotationMatrix();
  const Eigen::Matrix3d information =
      world_R_previous.transpose() * WorldInformation(step, map, points) * world_R_previous;
  return {control ? step.control : Between(step.world_T_previous, step.world_T_robot),
          0.5 * (information + information.transpose()),  // symmetric to the last bit
          step.matched};
}

Eigen::Matrix3d EdgeModel::WorldInformation(const Step& step, const map::OccupancyGrid& map,
                                            const scan_matching::ScanPoints& points) const {
  // Without a match there is the motion model's covariance only, which step carries then.
  if (!step.matched) return step.world_covariance.inverse();
  switch (options_.information) {
    case Information::kProposal:
      return step.world_covariance.inverse();
    case Information::kHessian:
      return options_.hessian_gain * gauss_newton_.InformationAt(map, points, step.world_T_robot) +
             scan_matching::GaussNewton::WeakPrior();
    case Information::kConstant:
      break;
  }
  return backend::InformationFromSigmas(options_.constant_sigma_m, options_.constant_sigma_rad);
}

}  // namespace gmapping_spa::particle_filter
