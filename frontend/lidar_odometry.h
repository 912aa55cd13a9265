// SPDX-License-Identifier: BSD-3-Clause
// Odometry by matching every scan with what was seen on the last metres.
#ifndef GMAPPING_SPA_FRONTEND_LIDAR_ODOMETRY_H_
#define GMAPPING_SPA_FRONTEND_LIDAR_ODOMETRY_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/motion_prior.h"
#include "frontend/particle_filter/particle_filter.h"
#include "frontend/scan_matching/correlative_matching.h"
#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_points.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/odometry_check.h"
#include "frontend/sliding_map.h"
#include "frontend/sweep_duration.h"
#include "frontend/wheel_trust.h"

namespace gmapping_spa::frontend {

// What a scan says about the motion since the scan before.
struct ScanMotion {
  backend::SE2 motion;  // the likeliest
  // All motions that the scan does not tell apart, the likeliest first; empty when there is one.
  std::vector<particle_filter::ParticleFilter::Control> alternatives;
  // How sure the wheels, which agree with it, have proved to be: a factor on the standard
  // deviations that are expected of them, at most 1.
  double noise = 1.0;
  // Of the robot during the scan: a twist in its frame (m/s, m/s, rad/s).
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  bool searched = false;          // whether the guesses did not do and a window was searched
  bool wheels_rejected = false;   // whether the motion is not what the wheels say
  bool wheels_silent = false;     // whether the wheels stand still while the robot moves
  bool wheels_turn_only = false;  // whether the wheels have never told a way, and the robot drives
  bool wheels_late = false;       // whether the wheels tell motions later than the scans
  bool wheels_mirrored = false;   // whether the wheels turn the other way than the scans
  // Whether neither the scan nor the wheels tell how far the robot has gone, as in a corridor.
  bool unobserved = false;
  // Whether the wheels alone tell how far: the scan fits as well farther on or farther back.
  bool unchecked = false;
  bool matched = true;  // whether the scan fits what was seen before
  // Where the robot was lost, and the last scans fit each other: so many, this one included, are
  // the begin of a new piece of map; how it lies to what was before is not known. Else zero.
  int new_piece_scans = 0;
  bool wheels_told_way_to_piece = false;  // whether the wheels had a say all the while
};

// Matches scans with a local map of its own, in its own frame. A particle's map would hold the
// robot to walls of long ago as soon as they are in reach, and tear the way there from the way on:
// where the path returns, is for the loop closing to find.
class LidarOdometry {
 public:
  struct Options {
    scan_matching::GaussNewton::Options gauss_newton;
    scan_matching::EndpointModel::Options endpoint;
    map::OccupancyGrid::Options grid;
    // Of the map that scans are matched with, in place of the grid's own: what is seen through more
    // often than this was a person who went by.
    double occupied_threshold = 0.25;
    MotionPrior::Options prior;
    // Time from the first beam of a scan to the last one, s; learned where it is not given.
    std::optional<double> sweep_duration_s;
    // A scan is entered into the map after this much motion, one of few beams the sooner. The map
    // is given up for one of half that many scans when it holds so many.
    double insert_m = 0.5;
    double insert_rad = 0.3;
    int map_scans = 80;
    // A match that fits less than this part of what recent scans did is looked into.
    double doubt_below = 0.85;
    // So many scans in a row that fit badly show a place that has changed; fewer are not entered.
    int doubtful_scans = 3;
    // A robot whose scans fit nothing before, but each other, for so long begins a new piece; for
    // longer where its beams are just shorter than expected: something may hide the walls.
    double new_piece_s = 1.0;
    double new_piece_if_hidden_s = 10.0;
    int new_piece_scans = 5;
    friend bool operator==(const Options&, const Options&) = default;
  };

  explicit LidarOdometry(const Options& options);

  // The motion since the scan before, given what the wheels say about it. Of the first scan: none.
  ScanMotion MatchScan(const sensor::LaserScan& scan, const sensor::OdometryCheck::Step& wheels);

  // Time from the first beam of a scan to the last one, s, by which scans are to be deskewed; 0
  // where they seem to be measured at once.
  double sweep_s() const;
  // Whether that is far from what the log tells.
  bool sweep_contradicts_log() const { return sweep_.contradicts_log(); }
  // By which the wheels' turns are corrected.
  const WheelCalibration& wheel_calibration() const { return wheel_trust_.calibration(); }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(map_, odom_T_robot_, odom_T_inserted_, stamp_s_, usual_motion_, usual_duration_s_,
            usual_fit_, usual_unknown_, drove_unseen_, wheel_trust_, sweep_, fits_along_, scans_,
            doubtful_scans_, unsure_scans_, new_piece_begin_s_, new_piece_scans_, wheels_told_all_,
            seen_through_, contradicted_);
    bool is_lost = new_piece_ != nullptr;
    archive(is_lost);
    if (!is_lost) return;
    if (!new_piece_) new_piece_ = std::make_unique<LidarOdometry>(options_);
    archive(*new_piece_);
  }

 private:
  // A pose of the robot and how well the scan fits there.
  struct Match {
    backend::SE2 odom_T_robot;
    scan_matching::Evidence evidence;
    bool tells_position = true;  // whether the scan surely binds it in every direction
    double seen_through = 0.0;   // number of beams that pass through walls
    double log_posterior = 0.0;  // up to a constant
  };

  bool IsLost(const Match& match) const;
  bool IsJump(const Match& match, const MotionPrior& prior, bool is_gap) const;
  bool IsDoubtful(const Match& match) const;
  ScanMotion GoOnLost(const Match& best, const sensor::LaserScan& scan,
                      const sensor::OdometryCheck::Step& wheels,
                      const std::optional<WheelMotion>& guess);
  double DurationRatio(double duration_s) const;
  backend::SE2 SameVelocity(double duration_s) const;
  Eigen::Vector3d VelocityOf(const backend::SE2& motion, double duration_s) const;
  sensor::LaserScan Deskewed(const sensor::LaserScan& scan, const Eigen::Vector3d& velocity) const;
  MotionPrior MakePrior(const std::optional<WheelMotion>& wheels, double duration_s) const;
  Match Track(const backend::SE2& initial, const MotionHypothesis& hypothesis) const;
  void CountBehindWalls(Match* match) const;
  static std::vector<backend::SE2> SearchCenters(const MotionPrior& prior,
                                                 const scan_matching::SearchWindow& window);
  bool FitsAlong(const Match& match, const backend::SE2& motion) const;
  static bool MayLeadToNextPeak(const MotionPrior& prior, bool by_wheels);
  bool SearchUntilOneConvinces(const MotionPrior& prior, bool search_anyway,
                               std::vector<Match>* matches);
  std::vector<Match> Search(const backend::SE2& center, const scan_matching::SearchWindow& window);
  bool IsConvincing(const Match& match, const MotionPrior& prior) const;
  double Nats(const Match& match, double least_unknown) const;
  void Rank(const MotionPrior& prior, std::vector<Match>* matches) const;
  void Learn(const Match& match, double duration_s);
  void LearnVelocity(const Match& match, double duration_s);

  Options options_;
  scan_matching::GaussNewton gauss_newton_;
  SlidingMap map_;
  scan_matching::ScanPoints points_;  // of the scan at hand
  double unseen_ahead_ = 0.0;         // number of its beams that are expected to see what is new
  // Whether the wheels told a way while there were no scans, and none was entered since.
  bool drove_unseen_ = false;
  backend::SE2 odom_T_robot_;
  backend::SE2 odom_T_inserted_;  // when a scan was last entered
  double stamp_s_ = 0.0;
  Eigen::Vector3d usual_motion_ = Eigen::Vector3d::Zero();  // a twist, running mean of few scans
  double usual_duration_s_ = 0.1;                           // running mean
  double usual_fit_ = 0.6;                                  // running mean
  double usual_unknown_ = 1.0;  // part of the beams that ends in unseen space, running mean
  WheelTrust wheel_trust_;
  SweepDuration sweep_;
  bool fits_along_ = false;  // whether the last scan that was tried fits farther on and back, too
  int scans_ = 0;            // seen
  int doubtful_scans_ = 0;   // in a row
  int unsure_scans_ = 0;     // in a row, of which no match convinced
  // Of a robot that is lost: what its scans say to each other.
  std::unique_ptr<LidarOdometry> new_piece_;
  double new_piece_begin_s_ = 0.0;  // stamp of its first scan
  int new_piece_scans_ = 0;         // since then
  bool wheels_told_all_ = false;    // since the robot is lost
  // Numbers of beams in all these scans, at where the robot would be if it were not lost.
  double seen_through_ = 0.0;
  double contradicted_ = 0.0;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_LIDAR_ODOMETRY_H_
