// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/localization_table.h"

#include <algorithm>

#include "backend/scheduling/covariances.h"
#include "backend/text.h"

namespace gmapping_spa::apps {
namespace {

// That of another pose which moves with the one whose covariance it is, as a rigid body does.
Eigen::Matrix3d MovedAlong(const Eigen::Matrix3d& covariance, const backend::SE2& from,
                           const backend::SE2& to) {
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -(to.y - from.y);
  jacobian(1, 2) = to.x - from.x;
  return jacobian * covariance * jacobian.transpose();
}

// Without closures that the back end rejects, and without what is known next to nothing of: edges
// that lead to pieces which were never joined. The nodes of these are held, so that all poses are
// determined.
backend::PoseGraph EdgesThatTell(const frontend::ImprovedGmapping& gmapping,
                                 const backend::PoseGraph& graph) {
  const loop_closure::Pieces& pieces = gmapping.loop_closer().pieces();
  const std::vector<bool> is_joined =
      pieces.Largest(gmapping.session()->nodes(), gmapping.loop_closer().closures());
  const auto is_placed = [&](std::int64_t node) {
    return is_joined[pieces.PieceOf(static_cast<int>(node))];
  };
  backend::PoseGraph used{graph.nodes, {}};
  for (backend::Node& node : used.nodes) node.fixed = node.fixed || !is_placed(node.id);
  const auto& rejected = gmapping.graph_thread().rejected_closures();
  for (const backend::Edge& edge : graph.edges) {
    const bool is_rejected = std::any_of(rejected.begin(), rejected.end(), [&](const auto& one) {
      return one.i == edge.i && one.j == edge.j;
    });
    if (!is_rejected && is_placed(edge.i) && is_placed(edge.j)) used.edges.push_back(edge);
  }
  return used;
}

}  // namespace

std::vector<LocalizedScan> LocalizedScans(const frontend::ImprovedGmapping& gmapping,
                                          const frontend::SlamResult& result,
                                          backend::Optimizer* optimizer) {
  const std::vector<backend::Node>& nodes = result.graph.nodes;
  const int first_node = gmapping.session()->nodes();
  const backend::PoseGraph used = EdgesThatTell(gmapping, result.graph);
  std::vector<backend::EdgeNodes> pairs;
  for (int node = first_node; node < static_cast<int>(nodes.size()); ++node) {
    pairs.push_back({node, node});
  }
  const std::vector<Eigen::Matrix3d> covariances = backend::Covariances(used, pairs, optimizer);

  std::vector<LocalizedScan> scans;
  const auto first_row = static_cast<std::size_t>(gmapping.session()->scans());
  for (std::size_t row = first_row; row < result.trajectory.size(); ++row) {
    LocalizedScan scan{result.trajectory[row], result.is_placed[row]};
    const auto after = std::upper_bound(
        nodes.begin() + first_node, nodes.end(), scan.pose.stamp_s,
        [](double stamp_s, const backend::Node& node) { return stamp_s < node.stamp_s; });
    const auto node = std::max(after - nodes.begin() - 1, std::ptrdiff_t{first_node});
    scan.covariance = MovedAlong(covariances[node - first_node], nodes[node].world_T_node,
                                 scan.pose.world_T_robot);
    scans.push_back(scan);
  }
  return scans;
}

void WriteLocalization(const std::vector<LocalizedScan>& scans, std::ostream& out) {
  out << "stamp_s,status,x_m,y_m,theta_rad,cov_xx,cov_xy,cov_xtheta,cov_yy,cov_ytheta,"
         "cov_thetatheta\n";
  for (const LocalizedScan& scan : scans) {
    out << backend::ShortestFixedText(scan.pose.stamp_s);
    if (!scan.is_known) {
      out << ",unknown,,,,,,,,,\n";
      continue;
    }
    const backend::SE2& pose = scan.pose.world_T_robot;
    const Eigen::Matrix3d& c = scan.covariance;
    out << ",known";
    for (const double number :
         {pose.x, pose.y, pose.theta, c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)}) {
      out << ',' << backend::ShortestText(number);
    }
    out << '\n';
  }
}

}  // namespace gmapping_spa::apps
