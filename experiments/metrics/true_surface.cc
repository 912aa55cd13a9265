// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/true_surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "experiments/metrics/grid_ray.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

constexpr int kNeighborCells = 3;
constexpr double kSideCells = 2.0;
constexpr double kMaxOffLineCells = 0.6;  // the steps of a slanted wall are half a cell off

std::vector<SurfaceElement> FindSurface(const TrinaryMap& truth) {
  std::vector<SurfaceElement> surface;
  for (int row = 0; row < truth.height; ++row) {
    for (int column = 0; column < truth.width; ++column) {
      VisitSurface(truth, column, row, [&](int side, const Segment& edge) {
        surface.push_back({.column = column, .row = row, .side = side, .edge = edge, .across = {}});
      });
    }
  }
  return surface;
}

Eigen::Vector2d Facing(const SurfaceElement& element) {
  return {kSides[element.side][0], kSides[element.side][1]};
}

// The normal of the line through the edges near `element`, if there is one; see the header.
std::optional<Eigen::Vector2d> StraightNormal(const std::vector<SurfaceElement>& surface,
                                              const SurfaceElement& element, double resolution_m) {
  const auto row_begins = [&](int row) {
    return std::lower_bound(surface.begin(), surface.end(), row,
                            [](const SurfaceElement& e, int r) { return e.row < r; });
  };
  std::vector<Eigen::Vector2d> points;  // in cells, from the middle of the element
  Eigen::Vector2d mean = Eigen::Vector2d::Zero(), facing = mean;
  const auto end = row_begins(element.row + kNeighborCells + 1);
  for (auto other = row_begins(element.row - kNeighborCells); other != end; ++other) {
    const Eigen::Vector2d point = (other->middle() - element.middle()) / resolution_m;
    if (point.norm() > kNeighborCells + 1e-6 || Facing(*other).dot(Facing(element)) < 0.0) continue;
    points.push_back(point);
    mean += point;
    facing += Facing(*other);
  }
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  const Eigen::Vector2d normal =
      axes.eigenvectors().col(0) * (axes.eigenvectors().col(0).dot(facing) < 0.0 ? -1.0 : 1.0);
  const Eigen::Vector2d along = axes.eigenvectors().col(1);
  double first = 0.0, last = 0.0;
  for (const Eigen::Vector2d& p : points) {
    if (std::abs((p - mean).dot(normal)) > kMaxOffLineCells) return std::nullopt;
    first = std::min(first, p.dot(along));
    last = std::max(last, p.dot(along));
  }
  const double side = kSideCells - 1e-6;
  if (-first < side || last < side) return std::nullopt;
  return normal;
}

// The length in metres of the ray from `point` to the first cell that is as `ends` says, capped.
template <typename Ends>
double FreeWay(const TrinaryMap& truth, const Eigen::Vector2d& point,
               const Eigen::Vector2d& direction, const Ends& ends) {
  double way = 2.0 * kReach_m / truth.resolution_m;
  VisitCellsAlong(ToCells(truth, point), direction, way,
                  [&](int column, int row, double begin, double end) {
                    // On the edge where it starts, the ray touches the cells on both sides.
                    if (end - begin < 1e-6 || !ends(column, row)) return true;
                    way = begin;
                    return false;
                  });
  return way * truth.resolution_m;
}

}  // namespace

std::vector<SurfaceElement> FindSeenSurface(const TrinaryMap& truth, const SeenSpace& seen) {
  const std::vector<SurfaceElement> surface = FindSurface(truth);
  const auto is_seen = [&](int column, int row) { return seen.IsSeen(column, row); };
  const auto is_solid = [&](int column, int row) {
    return StateAt(truth, column, row) != CellState::kFree;
  };
  std::vector<SurfaceElement> seen_surface;
  for (SurfaceElement element : surface) {
    if (!seen.IsSideSeen(element.column, element.row, element.side)) continue;
    if (const auto normal = StraightNormal(surface, element, truth.resolution_m)) {
      const Eigen::Vector2d middle = element.middle();
      element.across = {.normal = *normal,
                        .half_length_m = kSideCells * truth.resolution_m,
                        .behind_m = 0.5 * FreeWay(truth, middle, -*normal, is_seen),
                        .in_front_m = 0.5 * FreeWay(truth, middle, *normal, is_solid)};
    }
    seen_surface.push_back(element);
  }
  return seen_surface;
}

}  // namespace gmapping_spa::metrics
