// SPDX-License-Identifier: BSD-3-Clause
// A robot that is driven from a page, and SLAM that makes maps of it meanwhile.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_SESSION_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_SESSION_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/drive/drive_controls.h"
#include "experiments/drive/drive_hub.h"
#include "experiments/drive/driven_robot.h"
#include "experiments/drive/recorded_tour.h"
#include "experiments/drive/slam_variant.h"
#include "experiments/simulation/way_point_follower.h"
#include "experiments/view/view_server.h"

namespace gmapping_spa::drive {

// By the runs of variants that have come to an end.
using VariantResults = std::map<int, std::shared_ptr<const VariantResult>>;

struct DriveSetup {
  simulation::Scene scene;
  simulation::SimulationOptions options;
  map::TrinaryMap truth;
  DriveTitle title;
  view::ServerOptions server;
  // Throws std::runtime_error with one line where a choice makes no sense.
  std::function<VariantSetup(const VariantChoice&)> make_variant;
  // Writes the tour; returns a line for people. Empty: nothing can be saved.
  std::function<std::string(const class DriveSession&, const VariantResults&)> save;
  std::function<bool()> is_asked_to_stop;
};

class DriveSession {
 public:
  // Throws as ViewServer does.
  DriveSession(DriveSetup setup, const VariantChoice& first);
  ~DriveSession();
  DriveSession(const DriveSession&) = delete;
  DriveSession& operator=(const DriveSession&) = delete;

  std::uint16_t port() const { return server_.port(); }
  const RecordedTour& tour() const { return tour_; }
  const DrivenRobot& robot() const { return robot_; }
  std::vector<std::pair<int, VariantChoice>> variants() const;
  std::size_t saved_steps() const { return saved_steps_; }

  // Drives as it was driven before.
  void Replay(const std::vector<DriveCommand>& commands);

  // Does what the page wants by now, and a step of the robot unless it stands and nobody wants it
  // to move, or nobody looks.
  void Tick();

  // Drives on until is_asked_to_stop, `speed` times as fast as time goes.
  void Run(double speed);

 private:
  struct Throttle;
  // State, note, steps, points of the way, noise and slips: while they are the same, all is.
  using Published = std::tuple<std::string, std::string, std::size_t, std::size_t, double, double>;

  void AddVariant(const VariantChoice& choice);
  void RemoveVariant(int run);
  void SetGoal(const Eigen::Vector2d& goal);
  bool Drives(const DriveWishes& wishes);
  DriveCommand CommandOf(const DriveWishes& wishes);
  void GiveUpWhenBlocked();
  void Save();
  void Publish(const std::string& state);

  DriveSetup setup_;
  DriveControls controls_;
  RecordedTour tour_;
  DrivenRobot robot_;
  DriveHub hub_;
  view::ViewServer server_;  // ends before what its conversations use
  std::map<int, std::unique_ptr<SlamVariant>> variants_;

  std::optional<simulation::WayPointFollower> follower_;
  simulation::WayPoints way_;
  double blocked_s_ = 0.0;   // on the way
  double standing_s_ = 0.0;  // since anything was wanted
  double odometry_noise_, slips_per_m_;
  std::string note_;
  bool was_held_ = false;  // a key, in the last step
  std::size_t saved_steps_ = 0;
  std::shared_ptr<Throttle> truth_throttle_;
  Published published_;
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_SESSION_H_
