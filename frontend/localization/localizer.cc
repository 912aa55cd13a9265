// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/localizer.h"

#include <algorithm>
#include <cmath>

namespace gmapping_spa::localization {

using backend::SE2;

Localizer::Localizer(const Options& options, const map::OccupancyGrid* map)
    : options_(options), guesses_(options.guesses, map), views_(options.views) {}

void Localizer::Restart() {
  views_ = Views(options_.views);
  way_m_ = searched_m_ = 0.0;
  held_map_T_odom_.reset();
  map_T_odom_.reset();
}

Localizer::Outcome Localizer::AddScan(const sensor::LaserScan& scan, const SE2& motion) {
  way_m_ += motion.translation().norm();
  Outcome outcome;
  if (!searches() && way_m_ > found_m_ + options_.confirm_m) return outcome;
  if (!views_.Add(scan, motion)) return outcome;
  if (searches()) {
    outcome.located = Search();
    if (!outcome.located) return outcome;
    // From here on the views are those that confirm it.
    map_T_odom_ = outcome.located->map_T_robot;
    found_m_ = way_m_;
    views_ = Views(options_.views);
  } else if (way_m_ > found_m_ + options_.confirm_from_m && IsContradicted()) {
    Restart();
    outcome.taken_back = true;
  }
  return outcome;
}

std::optional<Located> Localizer::Search() {
  const bool is_patient = way_m_ > options_.patient_after_m;
  if (is_patient && way_m_ < searched_m_ + options_.patient_every_m) return std::nullopt;
  searched_m_ = way_m_;
  const std::vector<PlaceGuess> guesses = guesses_.Find(views_);
  if (guesses.empty()) return std::nullopt;
  const PlaceGuess& best = guesses.front();
  double second = -1.0;  // all is contradicted elsewhere
  for (const PlaceGuess& guess : guesses) {
    if (!IsSame(best.map_T_robot, guess.map_T_robot)) second = std::max(second, guess.Support());
  }
  Located located{.map_T_robot = best.map_T_robot,
                  .explained = best.evidence.explained / best.evidence.all(),
                  .margin = best.Support() - second};
  if (!StandsOut(located)) return std::nullopt;
  located.map_information =
      options_.information_gain * guesses_.InformationAt(views_, located.map_T_robot);
  return located;
}

// By far, or for long enough.
bool Localizer::StandsOut(const Located& best) {
  if (best.explained < options_.min_explained_held || best.margin < options_.min_margin_held) {
    held_map_T_odom_.reset();
    return false;
  }
  if (best.explained >= options_.min_explained && best.margin >= options_.min_margin) return true;
  const SE2 map_T_odom = best.map_T_robot * Inverse(views_.odom_T_robot());
  const bool is_held =
      held_map_T_odom_ && IsSame(*held_map_T_odom_ * views_.odom_T_robot(), best.map_T_robot);
  if (!is_held) held_since_m_ = way_m_;
  held_map_T_odom_ = map_T_odom;
  return way_m_ >= held_since_m_ + options_.held_m;
}

bool Localizer::IsSame(const SE2& a, const SE2& b) const {
  const SE2 off = Between(a, b);
  return off.translation().norm() <= options_.same_m && std::abs(off.theta) <= options_.same_rad;
}

// Follows the map on the way: the motion alone drifts.
bool Localizer::IsContradicted() {
  const PlaceGuess here = guesses_.Near(views_, *map_T_odom_ * views_.odom_T_robot());
  map_T_odom_ = here.map_T_robot * Inverse(views_.odom_T_robot());
  return here.evidence.contradicted > options_.max_contradicted * here.evidence.explained;
}

}  // namespace gmapping_spa::localization
