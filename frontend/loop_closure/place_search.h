// SPDX-License-Identifier: BSD-3-Clause
// Recognizes places that were seen before, wherever the estimate believes the robot to be.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PLACE_SEARCH_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PLACE_SEARCH_H_

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/local_map.h"
#include "frontend/loop_closure/place_descriptor.h"
#include "frontend/scan_matching/correlative_matching.h"

namespace gmapping_spa::loop_closure {

// A place that looks like another one, and how they lie to each other.
struct PlaceMatch {
  int old_node = 0;
  backend::SE2 old_T_node;  // to a cell of the search
  double score = 0.0;       // of the correlative match, and of the best one elsewhere
  double runner_up_score = 0.0;
};

// Keeps a place each few metres of driving: what was seen around it and a descriptor of that.
class PlaceSearch {
 public:
  struct Options {
    double reach_m = 8.0;       // of driving to either side of a place, for what was seen there
    double cell_m = 0.25;       // at most one end point in each
    int max_points = 100;       // of a place when it is looked for in others
    int shortlist = 4;          // places that are searched: those with the most similar descriptors
    double apart_m = 6.0;       // of driving, between places of the shortlist
    double max_likeness = 0.7;  // of a place to itself elsewhere nearby: corridors are not found
    double window_m = 4.0;      // in which the search looks for one place around the other
    scan_matching::CorrelativeMatcher::Options search{
        .field = {.resolution_m = 0.25, .sigma_m = 0.25},
        .pyramid_levels = 6,
        .min_score = 0.6,
        .peak_separation_m = 1.0,
        .peak_separation_rad = 0.2,
        .runner_up_floor = 0.85,
        .with_covariance = false};
    friend bool operator==(const Options&, const Options&) = default;
  };

  explicit PlaceSearch(const Options& options) : options_(options) {}

  // Makes node `node` a place. Later ones come later.
  void Add(const std::vector<backend::SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
           int node);

  int size() const { return static_cast<int>(places_.size()); }
  int NodeOf(int place) const { return places_.at(place).node; }

  // Where a place was seen before, among the earlier ones for whose node `may_match` says so: at
  // the most similar ones exhaustively, in all headings.
  std::vector<PlaceMatch> Find(int place, const std::vector<double>& ways_driven_m,
                               const std::function<bool(int node)>& may_match) const;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(places_);
  }

 private:
  struct Place {
    int node;
    std::vector<Eigen::Vector2f> points;  // in the frame of the node
    PlaceDescriptor descriptor;
    bool is_distinct;  // from itself, moved

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(node, points, descriptor, is_distinct);
    }
  };

  bool IsDistinct(const std::vector<Eigen::Vector2d>& points) const;
  std::vector<const Place*> Shortlist(int place, const std::vector<double>& ways_driven_m,
                                      const std::function<bool(int node)>& may_match) const;

  Options options_;
  std::vector<Place> places_;  // in ascending order of the nodes
};

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PLACE_SEARCH_H_
