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
}

std::optional<Located> Localizer::AddScan(const sensor::LaserScan& scan, const SE2& motion) {
  way_m_ += motion.translation().norm();
  if (!views_.Add(scan, motion)) return std::nullopt;
  const bool is_patient = way_m_ > options_.patient_after_m;
  if (is_patient && way_m_ < searched_m_ + options_.patient_every_m) return std::nullopt;
  searched_m_ = way_m_;
  std::optional<Located> located = Decide(guesses_.Find(views_));
  if (located) {
    located->map_information =
        options_.information_gain * guesses_.InformationAt(views_, located->map_T_robot);
  }
  return located;
}

// The best guess, unless too little speaks for it or another place is about as good.
std::optional<Located> Localizer::Decide(const std::vector<PlaceGuess>& guesses) const {
  if (guesses.empty()) return std::nullopt;
  const PlaceGuess& best = guesses.front();
  const double explained = best.evidence.explained / best.evidence.all();
  double second = -1.0;  // all is contradicted elsewhere
  for (const PlaceGuess& guess : guesses) {
    const SE2 off = Between(best.map_T_robot, guess.map_T_robot);
    const bool is_same =
        off.translation().norm() <= options_.same_m && std::abs(off.theta) <= options_.same_rad;
    if (!is_same) second = std::max(second, guess.Support());
  }
  const double margin = best.Support() - second;
  if (explained < options_.min_explained || margin < options_.min_margin) return std::nullopt;
  return Located{.map_T_robot = best.map_T_robot, .explained = explained, .margin = margin};
}

}  // namespace gmapping_spa::localization
