// The histories of all particles, stored once where they are shared.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_TRAJECTORY_TREE_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_TRAJECTORY_TREE_H_

#include <cstdint>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::particle_filter {

// Each particle is a leaf; the path from the root to it is its trajectory. Particles that descend
// from one ancestor share the path up to it.
class TrajectoryTree {
 public:
  using Index = std::int32_t;
  static constexpr Index kNone = -1;  // parent of a root

  // Adds a pose after `parent` and returns its index.
  Index Append(Index parent, const backend::SE2& world_T_robot);

  // Poses from the root to `leaf`.
  std::vector<backend::SE2> Path(Index leaf) const;

  // Forgets every pose that no leaf descends from, and renumbers `leaves` to match.
  void Prune(std::vector<Index>* leaves);

  std::size_t size() const { return vertices_.size(); }

 private:
  struct Vertex {
    backend::SE2 world_T_robot;
    Index parent = kNone;
  };
  std::vector<Vertex> vertices_;  // parents before children
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_TRAJECTORY_TREE_H_
