// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map_session.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gmapping_spa::frontend {

using backend::SE2;
using loop_closure::ClosureRecord;

namespace {

// From the frame of the map to that of a node in it.
Eigen::Matrix3d Rotated(const Eigen::Matrix3d& map_information, double node_theta) {
  Eigen::Matrix3d node_R_map = Eigen::Matrix3d::Identity();
  node_R_map.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(-node_theta).toRotationMatrix();
  return node_R_map * map_information * node_R_map.transpose();
}

}  // namespace

MapSession::MapSession(Use use, Known known) : use_(use), known_(std::move(known)) {
  MakeLocalizer();
}

void MapSession::BeginPiece() {
  localizer_->Restart();
  begin_s_.reset();
}

MapSession::Outcome MapSession::AddScan(const sensor::LaserScan& scan, const SE2& motion, int node,
                                        const SE2& robot_T_node) {
  if (!begin_s_) begin_s_ = scan.stamp_s;
  const localization::Localizer::Outcome outcome = localizer_->AddScan(scan, motion);
  if (outcome.taken_back) {
    found_.pop_back();
    return {.closure = std::nullopt, .taken_back = true};
  }
  if (!outcome.located) return {};
  found_.push_back({scan.stamp_s, scan.stamp_s - *begin_s_});
  return {.closure = ClosureAt(*outcome.located, node, robot_T_node)};
}

ClosureRecord MapSession::ClosureAt(const localization::Located& located, int node,
                                    const SE2& robot_T_node) const {
  const SE2 map_T_node = located.map_T_robot * robot_T_node;
  const auto squared_way = [&](const SE2& world_T_old) {
    return (world_T_old.translation() - map_T_node.translation()).squaredNorm();
  };
  const auto nearest =
      std::min_element(known_.nodes.begin(), known_.nodes.end(), [&](int a, int b) {
        return squared_way(known_.world_T_nodes[a]) < squared_way(known_.world_T_nodes[b]);
      });
  const SE2& map_T_old = known_.world_T_nodes[*nearest];
  ClosureRecord record;
  record.old_node = *nearest;
  record.node = node;
  record.distance_m = std::sqrt(squared_way(map_T_old));
  record.score = located.explained;
  record.runner_up_score = located.explained - located.margin;
  record.old_T_node = Between(map_T_old, map_T_node);
  record.information =
      loop_closure::WithMapErrors(Rotated(located.map_information, map_T_old.theta));
  record.source = loop_closure::Source::kLocalized;
  record.verdict = loop_closure::Verdict::kUnconfirmed;
  return record;
}

}  // namespace gmapping_spa::frontend
