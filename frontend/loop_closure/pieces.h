// SPDX-License-Identifier: BSD-3-Clause
// Pieces of the path between which nothing is known of the motion, and how closures join them.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PIECES_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PIECES_H_

#include <cstdint>
#include <span>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/se2.h"

namespace gmapping_spa::loop_closure {

// A robot that was lost goes on in a new piece. Poses within a piece belong together; those of two
// pieces do as soon as accepted closures lead from the one to the other.
class Pieces {
 public:
  // What is known of how pieces that are not joined lie to each other.
  enum class Sight : std::uint8_t {
    kScans,  // what scans tell: nothing
    kWheels  // where the wheels told the way from one to the next one: that
  };

  // The first piece begins at node 0, each further one at a node later than all before.
  void Begin(int node, bool wheels_told_way = false);

  int size() const { return static_cast<int>(first_nodes_.size()); }
  int PieceOf(int node) const;
  int FirstNode(int piece) const { return first_nodes_.at(piece); }
  // Whether the way to the first node of a piece from the piece before it is known.
  bool IsInSight(int piece, Sight sight) const {
    return sight == Sight::kWheels && wheels_told_way_.at(piece);
  }
  // Whether a piece other than the first one begins at the node.
  bool BeginsAt(int node) const;

  // The earliest piece that each piece is joined with, itself if there is none.
  std::vector<int> Joined(std::span<const backend::Edge> closures) const;

  // Of each piece whether it is joined with the one that the node belongs to.
  std::vector<bool> JoinedWith(int node, std::span<const backend::Edge> closures) const;

  // Of each piece whether it belongs to those joined that have the most of the first `nodes` nodes.
  std::vector<bool> Largest(int nodes, std::span<const backend::Edge> closures) const;

  // Moves pieces as a whole to where a closure puts them, so that optimization starts near the
  // solution; the earliest one of those joined stays, and so does a piece that its closures find
  // about right. Those not joined are left where they are.
  void Arrange(std::span<const backend::Edge> closures,
               std::vector<backend::SE2>* world_T_nodes) const;

  void Arrange(std::span<const backend::Edge> closures, backend::PoseGraph* path) const;

  // Puts groups of pieces that are not joined out of each other's sight: where they lie to each
  // other is not known, and whatever asks for what is near must not find it.
  void Separate(std::span<const backend::Edge> closures, Sight sight,
                std::vector<backend::SE2>* world_T_nodes) const;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(first_nodes_, wheels_told_way_);
  }

 private:
  void Move(int piece, const backend::SE2& to_T_from,
            std::vector<backend::SE2>* world_T_nodes) const;

  std::vector<int> first_nodes_ = {0};
  std::vector<std::uint8_t> wheels_told_way_ = {0};  // to each of them, from the piece before
};

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PIECES_H_
