// SPDX-License-Identifier: BSD-3-Clause
// Finds a robot in a map of which nothing is known but that it may be somewhere in there.
#ifndef GMAPPING_SPA_FRONTEND_LOCALIZATION_LOCALIZER_H_
#define GMAPPING_SPA_FRONTEND_LOCALIZATION_LOCALIZER_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "backend/se2.h"
#include "frontend/localization/place_guesses.h"
#include "frontend/localization/views.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::localization {

// Where a robot was found.
struct Located {
  backend::SE2 map_T_robot;
  // Of map_T_robot: inverse covariance of (x, y, theta) in the frame of the map.
  Eigen::Matrix3d map_information = Eigen::Matrix3d::Zero();
  double explained = 0.0;  // part of the beams that the map explains there
  double margin = 0.0;     // by which that is better than at any other place, see Localizer
};

// Compares what was seen on the last meters with the whole map, each time that the robot has moved
// on, until one place stands out, by far, or by less for some meters of driving. A place that
// repeats itself never does: then where the robot is stays unknown, until it gets to where only one
// place fits. On the meters that follow the map has to go on agreeing, or all is taken back.
class Localizer {
 public:
  struct Options {
    Views::Options views;
    PlaceGuesses::Options guesses;
    double same_m = 1.0;  // places nearer to each other are one
    double same_rad = 0.35;
    // Of all beams: so many are to be explained, and the part explained less the part contradicted
    // is to be better than at any other place by so much. On recorded logs of four buildings, in
    // the wrong building included, wrong places explained up to 0.53 with a margin of 0.41.
    double min_explained = 0.55;
    double min_margin = 0.5;
    // Or by so much, at the same place for so many meters.
    double min_explained_held = 0.45;
    double min_margin_held = 0.3;
    double held_m = 2.0;
    // For so long what is seen may take it back, from so many meters on: as soon as the part that
    // contradicts the map is so many times the part that it explains.
    double confirm_m = 5.0;
    double confirm_from_m = 1.0;
    double max_contradicted = 2.0;
    // Once it has driven this far in vain, a robot is looked for each so many meters only.
    double patient_after_m = 10.0;
    double patient_every_m = 1.0;
    double information_gain = 0.02;  // neighboring points share the errors of the maps
    friend bool operator==(const Options&, const Options&) = default;
  };

  // `map` stays as it is and outlives this.
  Localizer(const Options& options, const map::OccupancyGrid* map);

  struct Outcome {
    std::optional<Located> located;  // at the scan, once that is known
    bool taken_back = false;         // it is not true what was said before; the search goes on
  };

  // The next scan, deskewed, and the motion since the one before.
  Outcome AddScan(const sensor::LaserScan& scan, const backend::SE2& motion);

  // Whether it does not know where the robot is.
  bool searches() const { return !map_T_odom_; }

  // The robot is somewhere else: forgets what was seen.
  void Restart();

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(views_, way_m_, searched_m_, held_map_T_odom_, held_since_m_, map_T_odom_, found_m_);
  }

 private:
  std::optional<Located> Search();
  bool IsContradicted();
  bool StandsOut(const Located& best);
  bool IsSame(const backend::SE2& a, const backend::SE2& b) const;

  Options options_;
  PlaceGuesses guesses_;
  Views views_;
  double way_m_ = 0.0;
  double searched_m_ = 0.0;  // way when it was last looked for
  // What stands out, but not by far, and the way when it began to.
  std::optional<backend::SE2> held_map_T_odom_;
  double held_since_m_ = 0.0;
  // Once it is found, and the way then.
  std::optional<backend::SE2> map_T_odom_;
  double found_m_ = 0.0;
};

}  // namespace gmapping_spa::localization

#endif  // GMAPPING_SPA_FRONTEND_LOCALIZATION_LOCALIZER_H_
