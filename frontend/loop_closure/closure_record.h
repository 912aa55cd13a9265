// SPDX-License-Identifier: BSD-3-Clause
// What became of a candidate for a loop closure, and why.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CLOSURE_RECORD_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CLOSURE_RECORD_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "backend/se2.h"

namespace gmapping_spa::loop_closure {

// In the order in which they are tested; overlap is tested at the expected pose first of all.
enum class Verdict : std::uint8_t {
  kNoMatch,      // no pose in the window fits
  kAmbiguous,    // another pose fits nearly as well
  kUnstable,     // fine alignment leaves the peak of the search
  kOverlap,      // the scans saw too little in common
  kInlierRatio,  // what they saw in common does not look the same
  kSeenThrough,  // the one saw through what stands in the way for the other
  kMahalanobis,  // farther off than the graph's uncertainty allows
  kRival,        // the map repeats itself by about as much as the estimate would be moved
  kUnconfirmed,  // not enough other closures agree (yet)
  kReleased,     // was accepted, and is not any more
  kRejected,     // by hand
  kAccepted
};

const char* VerdictName(Verdict verdict);
// Nothing when no verdict has that name.
std::optional<Verdict> VerdictNamed(std::string_view name);

// Where a candidate came from.
enum class Source : std::uint8_t {
  kNear,       // it is near by the estimate, given the drift
  kPlace,      // the place looks like the other one: the estimate had no say
  kFollowed,   // it is near if a closure found so nearby on the way is right
  kLocalized,  // the robot, which might have been anywhere, was found in the map of before
  kHand        // somebody says so
};

const char* SourceName(Source source);
// Nothing when no source has that name.
std::optional<Source> SourceNamed(std::string_view name);

struct ClosureRecord {
  int old_node = 0;
  int node = 0;
  double path_length_m = 0.0;  // shortest between them in the graph
  double distance_m = 0.0;     // between their poses as estimated then
  double score = 0.0;          // of the correlative match, and of the best one elsewhere
  double runner_up_score = 0.0;
  double overlap = 0.0;       // part of the end points in the known part of the old map
  double inlier_ratio = 0.0;  // explained by the old map, per one of those; hits that end just
                              // outside of the known part count as well
  double mutual_inlier_ratio = 0.0;  // the same the other way round: of the old scans in the new
                                     // map. Not taken of candidates that are near
  double mahalanobis_sq = 0.0;       // squared Mahalanobis distance from the pose expected
  backend::SE2 old_T_node;           // measured
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // of old_T_node, as of backend::Edge
  Source source = Source::kNear;
  Verdict verdict = Verdict::kNoMatch;
  bool is_by_hand = false;  // somebody decided otherwise: the verdict is final
  Verdict overruled_verdict = Verdict::kNoMatch;  // that of the program, where it had one

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(old_node, node, path_length_m, distance_m, score, runner_up_score, overlap,
            inlier_ratio, mutual_inlier_ratio, mahalanobis_sq, old_T_node, information, source,
            verdict, is_by_hand, overruled_verdict);
  }
};

// What scans say about where they are in a map, given that no map is exact, whatever the number of
// points. `information` of (x, y, theta) may be singular, as in a corridor.
Eigen::Matrix3d WithMapErrors(const Eigen::Matrix3d& information);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CLOSURE_RECORD_H_
