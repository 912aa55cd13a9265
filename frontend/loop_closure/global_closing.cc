// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/global_closing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gmapping_spa::loop_closure {

using backend::SE2;

namespace {

// The last node at least so much driving before the end of the path; -1 if there is none.
int NodeBehind(const DrivenPath& path, double behind_m) {
  const std::vector<double>& ways = path.ways_driven_m;
  const auto after = std::upper_bound(ways.begin(), ways.end(), ways.back() - behind_m);
  return static_cast<int>(after - ways.begin()) - 1;
}

}  // namespace

GlobalCloser::GlobalCloser(const Options& options, const Verifier& verifier,
                           const DriftModel& drift, const CandidateOptions& candidates)
    : options_(options),
      verifier_(verifier),
      drift_(drift),
      candidates_(candidates),
      places_(options.search) {}

GlobalCloser::Decisions GlobalCloser::Update(const DrivenPath& path,
                                             const std::vector<SE2>& by_wheels,
                                             const ScanOfNode& scan_of_node,
                                             std::span<const backend::Edge> closures,
                                             std::vector<ClosureRecord>* records) {
  const Call call{path,     by_wheels, scan_of_node,
                  closures, records,   NodeBehind(path, options_.search.reach_m)};
  AddPlaces(call);
  FollowAll(call);
  const int place = places_.size() - 1;
  if (place >= 0 && !searched_[place]) {
    const double path_length_m = path.ways_driven_m[places_.NodeOf(place)];
    if (path_length_m >= last_search_m_ + options_.search_every_m) {
      last_search_m_ = path_length_m;
      Search(call, place);
    }
  }
  return Decide(call);
}

GlobalCloser::Decisions GlobalCloser::Finish(const DrivenPath& path,
                                             const std::vector<SE2>& by_wheels,
                                             const ScanOfNode& scan_of_node,
                                             std::span<const backend::Edge> closures,
                                             std::vector<ClosureRecord>* records) {
  const Call call{path, by_wheels, scan_of_node, closures, records, NodeBehind(path, 0.0)};
  AddPlaces(call);
  FollowAll(call);
  for (int place = 0; place < places_.size(); ++place) {
    if (!searched_[place]) Search(call, place);
  }
  return Decide(call);
}

void GlobalCloser::AddPlaces(const Call& call) {
  const std::vector<double>& ways = call.path.ways_driven_m;
  int node = places_.size() == 0 ? 0 : places_.NodeOf(places_.size() - 1);
  double last_m = places_.size() == 0 ? -options_.place_every_m : ways[node];
  for (; node <= call.last_node; ++node) {
    if (ways[node] < last_m + options_.place_every_m) continue;
    last_m = ways[node];
    places_.Add(call.path.world_T_nodes, call.scan_of_node, node);
    searched_.push_back(false);
  }
}

bool GlobalCloser::IsSettled(const Call& call, int node) const {
  const std::vector<double>& ways = call.path.ways_driven_m;
  return std::any_of(call.closures.begin(), call.closures.end(), [&](const backend::Edge& closure) {
    return std::abs(ways[closure.j] - ways[node]) <= options_.settled_m ||
           std::abs(ways[closure.i] - ways[node]) <= options_.settled_m;
  });
}

void GlobalCloser::Search(const Call& call, int place) {
  const int node = places_.NodeOf(place);
  const std::vector<double>& ways_driven = call.path.ways_driven_m;
  // However well it knows its surroundings, a piece of the path looks for those that it is not
  // joined with.
  const bool is_settled = IsSettled(call, node);
  if (is_settled && ways_driven[node] < kUnknownWay_m) return;
  searched_[place] = true;
  if (ways_driven[node] < options_.min_path_length_m) return;
  const std::vector<double> ways = ShortestWays(ways_driven, call.closures, node);
  const double min_path_length_m = is_settled ? kUnknownWay_m : options_.min_path_length_m;
  const auto may_match = [&](int old) {
    return ways[old] >= min_path_length_m && (ways[old] < kUnknownWay_m || old >= joinable_from_);
  };
  for (const PlaceMatch& match : places_.Find(place, ways_driven, may_match)) {
    if (IsExplained(call, node, match.old_node, match.old_T_node)) continue;
    const std::vector<SE2>& poses = call.path.world_T_nodes;
    const Candidate candidate{match.old_node, ways[match.old_node],
                              Between(poses[match.old_node], poses[node]).translation().norm()};
    ClosureRecord record;
    if (match.runner_up_score > options_.max_runner_up_score * match.score) {
      record.old_node = match.old_node;
      record.node = node;
      record.path_length_m = candidate.path_length_m;
      record.distance_m = candidate.distance_m;
      record.old_T_node = match.old_T_node;
      record.score = match.score;
      record.runner_up_score = match.runner_up_score;
      record.verdict = Verdict::kAmbiguous;
    } else {
      record = verifier_.VerifyAt(
          poses, call.scan_of_node, node, candidate,
          {match.old_T_node, {options_.seed_window_m, options_.seed_window_rad}});
    }
    AddSeed(call, record);
  }
  SearchNearWheels(call, node, ways);
}

// A place of another piece that the wheels say is near need not be recognized.
void GlobalCloser::SearchNearWheels(const Call& call, int node, const std::vector<double>& ways) {
  const std::vector<SE2>& poses = call.by_wheels;
  Candidate nearest{-1, kUnknownWay_m, candidates_.max_distance_m};
  for (int old = joinable_from_; old < node; ++old) {
    const double distance_m = Between(poses[old], poses[node]).translation().norm();
    if (ways[old] >= kUnknownWay_m && distance_m < nearest.distance_m) {
      nearest = {old, ways[old], distance_m};
    }
  }
  if (nearest.old_node < 0) return;
  const SE2 old_T_node = Between(poses[nearest.old_node], poses[node]);
  if (IsExplained(call, node, nearest.old_node, old_T_node)) return;
  AddSeed(call,
          verifier_.VerifyAt(call.path.world_T_nodes, call.scan_of_node, node, nearest,
                             {old_T_node, {options_.wheels_window_m, options_.wheels_window_rad}}));
}

// Whether the record has another piece about where the wheels say. They may be wrong, as of a robot
// that somebody has carried: they are a part of the proof.
bool GlobalCloser::WheelsAgree(const Call& call, const ClosureRecord& record) const {
  const std::vector<SE2>& poses = call.by_wheels;
  const SE2 off = Between(Between(poses[record.old_node], poses[record.node]), record.old_T_node);
  return record.path_length_m >= kUnknownWay_m &&
         off.translation().norm() <= options_.wheels_window_m &&
         std::abs(off.theta) <= options_.wheels_window_rad;
}

// Begins a hypothesis with what was found of a place, if it was verified, and follows it.
void GlobalCloser::AddSeed(const Call& call, const ClosureRecord& record) {
  call.records->push_back(record);
  call.records->back().source = Source::kPlace;
  if (record.verdict != Verdict::kUnconfirmed) return;
  ClosureSet& set = sets_.emplace_back();
  set.members.push_back(call.records->size() - 1);
  set.first_node = set.last_node = record.node;
  set.wheels_agree = WheelsAgree(call, record);
  Follow(call, -1, &set);
  Follow(call, +1, &set);
}

// Whether a hypothesis that there is says the same.
bool GlobalCloser::IsExplained(const Call& call, int node, int old_node,
                               const SE2& old_T_node) const {
  const SE2 pose = call.path.world_T_nodes[old_node] * old_T_node;
  return std::any_of(sets_.begin(), sets_.end(), [&](const ClosureSet& set) {
    if (node < set.first_node || node > set.last_node) return false;
    const SE2 off = Between(
        PredictedPose(call.path, NearestMember(call.path, *call.records, set, node), node), pose);
    return off.translation().norm() <= options_.proof.rival_m &&
           std::abs(off.theta) <= options_.proof.rival_rad;
  });
}

void GlobalCloser::FollowAll(const Call& call) {
  for (ClosureSet& set : sets_) {
    Follow(call, +1, &set);
  }
}

// Looks along the path, as long as there was a member not too long ago.
void GlobalCloser::Follow(const Call& call, int direction, ClosureSet* set) {
  const std::vector<double>& ways = call.path.ways_driven_m;
  int& frontier = direction > 0 ? set->last_node : set->first_node;
  for (int node = frontier + direction; node >= 0 && node <= call.last_node; node += direction) {
    if (std::abs(ways[node] - ways[frontier]) < options_.follow_every_m) continue;
    const ClosureRecord& member = NearestMember(call.path, *call.records, *set, node);
    if (std::abs(ways[node] - ways[member.node]) > options_.follow_up_to_m) break;
    frontier = node;
    Look(call, node, set);
  }
}

void GlobalCloser::Look(const Call& call, int node, ClosureSet* set) {
  const ClosureRecord member = NearestMember(call.path, *call.records, *set, node);
  const std::optional<Candidate> candidate = Predict(call, member, node);
  if (!candidate) return;
  const double path_length_m =
      std::abs(call.path.ways_driven_m[node] - call.path.ways_driven_m[member.node]);
  const SE2 old_T_node =
      Between(call.path.world_T_nodes[candidate->old_node], PredictedPose(call.path, member, node));
  ClosureRecord record =
      verifier_.VerifyAt(call.path.world_T_nodes, call.scan_of_node, node, *candidate,
                         {old_T_node,
                          {options_.seed_window_m + options_.window_m_per_m * path_length_m,
                           options_.seed_window_rad + options_.window_rad_per_m * path_length_m}});
  record.source = Source::kFollowed;
  call.records->push_back(record);
  switch (record.verdict) {
    case Verdict::kUnconfirmed:
      set->members.push_back(call.records->size() - 1);
      break;
    case Verdict::kNoMatch:
    case Verdict::kInlierRatio:
    case Verdict::kSeenThrough:
      ++set->contradictions;
      break;
    default:  // too little in common, or too little structure, for a verdict on the hypothesis
      break;
  }
}

// The old node that is nearest to where the node would be; none if that leads out of what is known.
std::optional<Candidate> GlobalCloser::Predict(const Call& call, const ClosureRecord& member,
                                               int node) const {
  const std::vector<SE2>& poses = call.path.world_T_nodes;
  const std::vector<double>& ways = call.path.ways_driven_m;
  const Eigen::Vector2d predicted = PredictedPose(call.path, member, node).translation();
  double nearest_m = candidates_.max_distance_m;
  std::optional<Candidate> nearest;
  for (int old = 0; old < node; ++old) {
    if (std::abs(ways[old] - ways[member.old_node]) > options_.old_window_m) continue;
    if (ways[node] - ways[old] < candidates_.min_path_length_m) continue;
    const double distance_m = (poses[old].translation() - predicted).norm();
    if (distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    nearest = {old, 0.0, Between(poses[old], poses[node]).translation().norm()};
  }
  // The way of the member and the ways to it: near enough, for a gate that decides about the set.
  if (nearest) {
    nearest->path_length_m = member.path_length_m + std::abs(ways[node] - ways[member.node]) +
                             std::abs(ways[nearest->old_node] - ways[member.old_node]);
  }
  return nearest;
}

GlobalCloser::Decisions GlobalCloser::Decide(const Call& call) {
  Decisions decisions;
  const std::vector<std::vector<std::size_t>> proven =
      ProvenSets(options_.proof, drift_, call.path, *call.records, sets_);
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    const double proof = ProofOf(options_.proof, call.path, *call.records, proven[k]);
    bool is_believed = !proven[k].empty();
    for (std::size_t other = 0; other < sets_.size() && is_believed; ++other) {
      if (other == k) continue;
      const double other_proof =
          ProofOf(options_.proof, call.path, *call.records, sets_[other].members);
      if (other_proof < options_.proof.rival_proof * proof) continue;
      if (static_cast<int>(sets_[other].members.size()) <
          options_.proof.min_per_contradiction * sets_[other].contradictions)
        continue;
      is_believed = !Contradict(options_.proof, call.path, *call.records, sets_[k], sets_[other]);
    }
    if (is_believed) {
      std::vector<std::size_t>& list = sets_[k].is_accepted ? decisions.accept : decisions.restore;
      list.insert(list.end(), proven[k].begin(), proven[k].end());
    } else if (sets_[k].is_accepted) {
      decisions.release.insert(decisions.release.end(), sets_[k].members.begin(),
                               sets_[k].members.end());
    }
    sets_[k].is_accepted = is_believed;
  }
  return decisions;
}

}  // namespace gmapping_spa::loop_closure
