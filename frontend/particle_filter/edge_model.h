// SPDX-License-Identifier: BSD-3-Clause
// What the pose graph is told about a particle's step.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_EDGE_MODEL_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_EDGE_MODEL_H_

#include <Eigen/Core>
#include <cstdint>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/particle_filter/trajectory_tree.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::particle_filter {

class EdgeModel {
 public:
  enum class Measurement : std::uint8_t {
    kParticle,  // the step of the particle
    kControl    // the control input: free of the jumps of a particle that finds back to old walls
  };
  enum class Information : std::uint8_t {
    kProposal,  // inverse of the covariance of eq. (12)
    kHessian,   // of scan matching at the new pose
    kConstant
  };

  struct Options {
    Measurement measurement = Measurement::kControl;
    Information information = Information::kProposal;
    double constant_sigma_m = 0.05;  // of kConstant
    double constant_sigma_rad = 0.01;
    double hessian_gain = 0.1;  // of kHessian: neighboring beams are not independent
    scan_matching::GaussNewton::Options gauss_newton;  // of kHessian
    friend bool operator==(const Options&, const Options&) = default;
  };

  // A step that a particle has just taken.
  struct Step {
    backend::SE2 world_T_previous;
    backend::SE2 world_T_robot;
    backend::SE2 control;
    Eigen::Matrix3d world_covariance;  // of the new pose given the previous one
    bool matched = false;              // whether the scan matcher succeeded
  };

  explicit EdgeModel(const Options& options);

  // `map` as it was when the step was taken.
  TrajectoryTree::Motion Measure(const Step& step, const map::OccupancyGrid& map,
                                 const scan_matching::ScanPoints& points) const;

 private:
  Eigen::Matrix3d WorldInformation(const Step& step, const map::OccupancyGrid& map,
                                   const scan_matching::ScanPoints& points) const;

  Options options_;
  scan_matching::GaussNewton gauss_newton_;
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_EDGE_MODEL_H_
