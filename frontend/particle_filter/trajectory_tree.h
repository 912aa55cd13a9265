// SPDX-License-Identifier: BSD-3-Clause
// The histories of all particles, stored once where they are shared.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_TRAJECTORY_TREE_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_TRAJECTORY_TREE_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "backend/se2.h"
#include "frontend/particle_filter/path_correction.h"

namespace gmapping_spa::particle_filter {

// Each particle is a leaf; the path from the root to it is its trajectory. Particles that descend
// from one ancestor share the path up to it.
class TrajectoryTree {
 public:
  using Index = std::int32_t;
  static constexpr Index kNone = -1;  // parent of a root

  // How a pose was reached from the one before, as it was measured then. Corrections do not touch
  // it.
  struct Motion {
    backend::SE2 previous_T_robot;
    Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  // of backend::Edge
    bool matched = false;  // whether the scan matcher succeeded; else by odometry alone

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(previous_T_robot, information, matched);
    }
  };

  struct Vertex {
    backend::SE2 world_T_robot;
    Motion motion;  // of a root: without meaning
    Index parent = kNone;
    int step = 0;  // number of ancestors

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(world_T_robot, motion, parent, step);
    }
  };

  // Adds a root; returns its index, as Append does.
  Index AddRoot(const backend::SE2& world_T_robot);
  Index Append(Index parent, const backend::SE2& world_T_robot, const Motion& motion);

  // From the root to `leaf`.
  std::vector<Vertex> Path(Index leaf) const;
  std::vector<backend::SE2> PosesOfPath(Index leaf) const;
  // The last `count` poses of it, fewer where there are no more, the latest one first.
  std::vector<backend::SE2> LatestPoses(Index leaf, int count) const;

  // Forgets every pose that no leaf descends from, and renumbers `leaves` to match.
  void Prune(std::vector<Index>* leaves);

  void SetPose(Index index, const backend::SE2& world_T_robot) {
    vertices_.at(index).world_T_robot = world_T_robot;
  }

  // Moves the poses of all particles as `correction` says for their steps.
  void Correct(const PathCorrection& correction);

  // Parents before children.
  const std::vector<Vertex>& vertices() const { return vertices_; }
  std::size_t size() const { return vertices_.size(); }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(vertices_);
  }

 private:
  std::vector<Vertex> vertices_;
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_TRAJECTORY_TREE_H_
