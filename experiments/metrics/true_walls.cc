// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/true_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gmapping_spa::metrics {
namespace {

constexpr double kJoinCells = 3.5;
constexpr double kMinCosine = 0.5 * std::numbers::sqrt3;  // 30 degrees

// Disjoint sets; the root of each is its smallest member.
class Sets {
 public:
  explicit Sets(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  std::size_t Root(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void Join(std::size_t i, std::size_t j) {
    const auto [first, second] = std::minmax({Root(i), Root(j)});
    parents_[second] = first;
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

std::vector<Stretch> JoinElements(const std::vector<SurfaceElement>& surface, double resolution_m,
                                  const std::function<bool(std::size_t)>& counts) {
  std::vector<std::size_t> members;  // by rows, as the surface is
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (surface[i].across && counts(i)) members.push_back(i);
  }
  Sets sets(surface.size());
  const int rows = static_cast<int>(std::ceil(kJoinCells)) + 1;
  for (std::size_t a = 0; a < members.size(); ++a) {
    const SurfaceElement& one = surface[members[a]];
    for (std::size_t b = a + 1; b < members.size(); ++b) {
      const SurfaceElement& other = surface[members[b]];
      if (other.row > one.row + rows) break;
      if ((other.middle() - one.middle()).norm() > kJoinCells * resolution_m) continue;
      if (other.across->normal.dot(one.across->normal) < kMinCosine) continue;
      sets.Join(members[a], members[b]);
    }
  }
  std::vector<Stretch> of_root(surface.size()), stretches;
  for (const std::size_t i : members) of_root[sets.Root(i)].push_back(i);
  for (Stretch& stretch : of_root) {
    if (!stretch.empty()) stretches.push_back(std::move(stretch));
  }
  return stretches;
}

double Length_m(const std::vector<SurfaceElement>& surface, const Stretch& stretch) {
  double length_m = 0.0;
  for (const std::size_t i : stretch) {
    const Eigen::Vector2d& normal = surface[i].across->normal;
    const Eigen::Vector2d along(-normal.y(), normal.x());
    length_m += std::abs(along.dot(surface[i].edge.to - surface[i].edge.from));
  }
  return length_m;
}

}  // namespace gmapping_spa::metrics
