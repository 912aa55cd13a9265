// SPDX-License-Identifier: BSD-3-Clause
// How types are written that know nothing of sessions: those of the public API, of Eigen, tiles of
// maps. All others have a function serialize.
#ifndef GMAPPING_SPA_FRONTEND_SESSION_PLAIN_DATA_H_
#define GMAPPING_SPA_FRONTEND_SESSION_PLAIN_DATA_H_

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cereal/cereal.hpp>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <tuple>

#include "backend/graph/pose_graph.h"
#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "frontend/map/tile.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/session/archive.h"

namespace gmapping_spa::session {

template <typename Archive>
void serialize(Archive& archive, backend::SE2& pose) {
  archive(pose.x, pose.y, pose.theta);
}

template <typename Archive>
void serialize(Archive& archive, backend::StampedPose& pose) {
  archive(pose.stamp_s, pose.world_T_robot);
}

template <typename Archive>
void serialize(Archive& archive, backend::Node& node) {
  archive(node.id, node.stamp_s, node.world_T_node, node.fixed);
}

template <typename Archive>
void serialize(Archive& archive, backend::Edge& edge) {
  archive(edge.i, edge.j, edge.i_T_j, edge.information, edge.kind);
}

template <typename Archive>
void serialize(Archive& archive, backend::PoseGraph& graph) {
  archive(graph.nodes, graph.edges);
}

template <typename Archive>
void serialize(Archive& archive, sensor::Beam& beam) {
  archive(beam.angle_rad, beam.range_m, beam.status);
}

template <typename Archive>
void serialize(Archive& archive, sensor::LaserScan& scan) {
  archive(scan.index, scan.stamp_s, scan.odom_T_robot, scan.robot_T_laser, scan.beams,
          scan.has_odometry, scan.sweep_s);
}

template <typename Archive, typename Scalar, int kRows, int kColumns>
void serialize(Archive& archive, Eigen::Matrix<Scalar, kRows, kColumns>& matrix) {
  static_assert(kColumns != Eigen::Dynamic);
  if constexpr (kRows == Eigen::Dynamic) {
    auto rows = static_cast<cereal::size_type>(matrix.rows());
    archive(cereal::make_size_tag(rows));
    matrix.resize(static_cast<Eigen::Index>(rows));
  }
  archive(
      cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}

// The cells that a beam has met, which are half of them or fewer, and which these are.
inline void SaveTile(const map::Tile& tile, SaveArchive* archive) {
  std::array<map::Cell, std::tuple_size_v<decltype(map::Tile::cells)>> known;
  std::array<std::uint16_t, map::Tile::kSize> is_known{};  // by bits, as `occupied`
  std::size_t count = 0;
  for (int y = 0; y < map::Tile::kSize; ++y) {
    for (int x = 0; x < map::Tile::kSize; ++x) {
      known[count] = tile.cell(x, y);
      const unsigned met = known[count].visits > 0 ? 1 : 0;
      is_known[y] = static_cast<std::uint16_t>(is_known[y] | met << x);
      count += met;
    }
  }
  archive->SaveBytes(is_known.data(), sizeof is_known);
  archive->SaveBytes(tile.occupied.data(), sizeof tile.occupied);
  archive->SaveBytes(known.data(), count * sizeof known[0]);
}

inline void LoadTile(LoadArchive* archive, map::Tile* tile) {
  std::array<std::uint16_t, map::Tile::kSize> is_known;
  archive->LoadBytes(is_known.data(), sizeof is_known);
  archive->LoadBytes(tile->occupied.data(), sizeof tile->occupied);
  for (int y = 0; y < map::Tile::kSize; ++y) {
    for (unsigned rest = is_known[y]; rest != 0; rest &= rest - 1) {
      archive->LoadBytes(&tile->cell(std::countr_zero(rest), y), sizeof(map::Cell));
    }
  }
}

// Tiles that several maps share are written once, and shared again by those that read them.
inline void save(SaveArchive& archive, const map::TilePtr& tile) {
  const auto [number, is_new] = archive.NumberOf(tile.get());
  archive(number);
  if (is_new) SaveTile(*tile, &archive);
}
inline void load(LoadArchive& archive, map::TilePtr& tile) {
  std::uint32_t number = 0;
  archive(number);
  tile.reset();
  if (number == 0) return;
  auto& tiles = archive.tiles();
  if (number > tiles.size() + 1) throw std::runtime_error("a tile without its cells");
  if (number == tiles.size() + 1) {
    tiles.emplace_back(new map::Tile);
    LoadTile(&archive, tiles.back().get());
  }
  tile = tiles[number - 1];
}

}  // namespace gmapping_spa::session

#endif  // GMAPPING_SPA_FRONTEND_SESSION_PLAIN_DATA_H_
