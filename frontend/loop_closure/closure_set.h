// SPDX-License-Identifier: BSD-3-Clause
// Closures that follow from one another along a stretch of driving, and whether to believe them.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CLOSURE_SET_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CLOSURE_SET_H_

#include <cstddef>
#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/loop_closure/drift.h"

namespace gmapping_spa::loop_closure {

// The path so far, and how far it was driven up to each node.
struct DrivenPath {
  const std::vector<backend::SE2>& world_T_nodes;
  const std::vector<double>& ways_driven_m;
};

// A hypothesis where the robot was: one closure found by the look of a place, and those that were
// found from there on by following the path to both sides.
struct ClosureSet {
  std::vector<std::size_t> members;  // positions in the records
  int contradictions = 0;            // looks at where it says the robot was, which did not fit
  int first_node = 0;                // the path has been followed from here
  int last_node = 0;                 // to here
  bool is_accepted = false;
  bool wheels_agree = false;  // on where another piece lies

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(members, contradictions, first_node, last_node, is_accepted, wheels_agree);
  }
};

struct ProofOptions {
  int min_members = 4;
  // Where a piece of the path lies as the wheels say: fewer, over less driving, as they are a part
  // of the proof.
  int min_members_by_wheels = 3;
  double wheels_proof = 0.7;
  // Of driving, from the first member to the last: so much where drift explains how far off the
  // member is for which that is easiest. Grows in proportion to how far off it is in standard
  // deviations beyond that: a corridor may look the same for 50 m, turned around.
  double min_span_m = 12.0;
  double max_mahalanobis_sq = 13.8;  // up to which drift explains it
  // No look of a building proves what drift can not have done: ten standard deviations, squared. A
  // building with two wings alike shows the same for as long as one drives.
  double impossible_mahalanobis_sq = 100.0;
  double min_per_contradiction = 3;  // members
  double consistent_sigmas = 2.0;    // of the drift on the way, for two members to go together
  // For two sets to agree: of the drift on the way between them, which must not be so long that
  // drift explains everything.
  double agree_sigmas = 2.0;
  double agree_within_m = 200.0;
  // Another hypothesis of the same stretch that is more than this off, and has at least this part
  // of the proof, leaves the decision open.
  double rival_m = 1.0;
  double rival_rad = 0.15;
  double rival_proof = 0.5;
  // Of closures near by the estimate: one that is so much easier to explain by drift, found within
  // so much driving, is far likelier than another that contradicts it.
  double rival_mahalanobis_sq = 6.0;
  double rival_within_m = 20.0;
  friend bool operator==(const ProofOptions&, const ProofOptions&) = default;
};

// Whether the loop through both closes within so many standard deviations of the drift on its way.
bool AreConsistent(const DriftModel& drift, double sigmas, const DrivenPath& path,
                   const ClosureRecord& a, const ClosureRecord& b);

// Of each set the members out of its largest pairwise consistent subset; empty when they prove
// nothing: too few of them, over too little driving for how far off they are, or too many
// contradictions. The driving of other sets that agree adds up: a robot that crosses what it knows
// again and again sees little of it each time.
std::vector<std::vector<std::size_t>> ProvenSets(const ProofOptions& options,
                                                 const DriftModel& drift, const DrivenPath& path,
                                                 const std::vector<ClosureRecord>& records,
                                                 const std::vector<ClosureSet>& sets);

// Whether the set says that the robot was elsewhere than what `rival` says of the same stretch.
bool Contradict(const ProofOptions& options, const DrivenPath& path,
                const std::vector<ClosureRecord>& records, const ClosureSet& set,
                const ClosureSet& rival);

// Whether a closure near by the estimate, which drift explains far more easily than `record`, says
// that the robot was elsewhere: where places look alike, the estimate decides.
bool HasLikelierRival(const ProofOptions& options, const DrivenPath& path,
                      const std::vector<ClosureRecord>& records, const ClosureRecord& record);

// Driving from the first member to the last.
double SpanOf(const DrivenPath& path, const std::vector<ClosureRecord>& records,
              const std::vector<std::size_t>& members);

// That driving, as a part of what it takes for how far off by drift the members are.
double ProofOf(const ProofOptions& options, const DrivenPath& path,
               const std::vector<ClosureRecord>& records, const std::vector<std::size_t>& members);

// The member whose node is nearest to `node` by driving.
const ClosureRecord& NearestMember(const DrivenPath& path,
                                   const std::vector<ClosureRecord>& records, const ClosureSet& set,
                                   int node);

// world_T_node as it would be in the part of the map that the nearest member leads to.
backend::SE2 PredictedPose(const DrivenPath& path, const ClosureRecord& member, int node);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CLOSURE_SET_H_
