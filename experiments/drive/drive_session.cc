// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/drive_session.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include "experiments/drive/page_files.h"
#include "experiments/drive/way_planner.h"
#include "experiments/simulation/scan_player.h"
#include "experiments/view/page_files.h"

namespace gmapping_spa::drive {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(100);  // of what is shown
constexpr double kStandS = 5.0;                           // then the time stands still, too
constexpr double kPatienceS = 3.0;                        // with what is in the way
constexpr auto kFarBehind = std::chrono::milliseconds(500);

// The page's own, and of those of the live view all that it does not replace.
std::vector<view::StaticFile> AllPageFiles() {
  std::vector<view::StaticFile> files = PageFiles();
  for (const view::StaticFile& file : view::PageFiles()) {
    const bool is_replaced =
        std::any_of(files.begin(), files.end(), [&](const auto& f) { return f.path == file.path; });
    if (!is_replaced) files.push_back(file);
  }
  return files;
}

bool Moves(const simulation::BodyVelocity& velocity) {
  return velocity.linear_m_s != 0.0 || velocity.angular_rad_s != 0.0;
}

}  // namespace

// Not more snapshots of a run than can be shown.
struct DriveSession::Throttle {
  bool Wants(const view::ViewServer& server) const {
    return server.CountClients() > 0 && !is_on_its_way &&
           std::chrono::steady_clock::now() - published >= kPeriod;
  }

  std::atomic<bool> is_on_its_way = false;
  std::chrono::steady_clock::time_point published;
};

DriveSession::DriveSession(DriveSetup setup, const VariantChoice& first)
    : setup_(std::move(setup)),
      controls_({.odometry_noise = setup_.options.odometry.noise,
                 .slips_per_m = setup_.options.odometry.slips_per_m}),
      tour_(setup_.options.lidar),
      robot_(&setup_.scene, setup_.title.world_T_start, setup_.options),
      hub_(setup_.title, setup_.truth, &controls_),
      server_(setup_.server, AllPageFiles(), hub_.Protocols()),
      standing_s_(kStandS),
      odometry_noise_(setup_.options.odometry.noise),
      slips_per_m_(setup_.options.odometry.slips_per_m),
      truth_throttle_(std::make_shared<Throttle>()) {
  AddVariant(first);
}

DriveSession::~DriveSession() { variants_.clear(); }

std::vector<std::pair<int, VariantChoice>> DriveSession::variants() const {
  std::vector<std::pair<int, VariantChoice>> variants;
  for (const auto& [run, variant] : variants_) {
    variants.emplace_back(run, variant->setup().choice);
  }
  return variants;
}

void DriveSession::AddVariant(const VariantChoice& choice) {
  int run = kTruthRun + 1;
  while (variants_.contains(run)) ++run;
  if (run > kMaxVariants) {
    note_ = "no more than " + std::to_string(kMaxVariants) + " maps at once";
    return;
  }
  VariantSetup variant = setup_.make_variant(choice);
  const auto throttle = std::make_shared<Throttle>();
  VariantListener listener;
  listener.wants_snapshot = [this, throttle] { return throttle->Wants(server_); };
  listener.on_snapshot = [this, throttle, run](view::Snapshot snapshot) {
    throttle->is_on_its_way = true;
    throttle->published = std::chrono::steady_clock::now();
    server_.Post(
        [this, throttle, run, shared = std::make_shared<view::Snapshot>(std::move(snapshot))] {
          hub_.Apply(run, std::move(*shared));
          throttle->is_on_its_way = false;
        });
  };
  listener.on_score = [this, run](const MapScore& score) {
    server_.Post([this, run, score] { hub_.SetScore(run, score); });
  };
  listener.on_state = [this, run](const std::string& state) {
    server_.Post([this, run, state] { hub_.SetVariantState(run, state); });
  };
  server_.Post([this, run, choice] { hub_.AddVariant(run, choice); });
  variants_[run] =
      std::make_unique<SlamVariant>(std::move(variant), &tour_, &setup_.truth,
                                    setup_.options.lidar.max_range_m, std::move(listener));
}

void DriveSession::RemoveVariant(int run) {
  if (variants_.erase(run) == 0) return;
  server_.Post([this, run] { hub_.RemoveVariant(run); });
}

void DriveSession::SetGoal(const Eigen::Vector2d& goal) {
  way_ = PlanWay(setup_.scene.world, robot_.world_T_robot().translation(), goal,
                 setup_.options.robot_radius_m);
  blocked_s_ = 0.0;
  follower_.reset();
  if (way_.empty()) {
    note_ = "there is no way to where you clicked";
  } else {
    follower_.emplace(way_, setup_.options.follower);
    note_.clear();
  }
}

bool DriveSession::Drives(const DriveWishes& wishes) {
  if (wishes.paused || server_.CountClients() == 0) return false;
  if (tour_.steps() == 0) return true;  // what it sees from the start
  const bool is_wanted = wishes.holds() || follower_.has_value();
  // Where the time stands still already, as after a save, rolling out waits, too.
  const bool rolls_out = Moves(robot_.velocity()) && standing_s_ < kStandS;
  standing_s_ = is_wanted || rolls_out ? 0.0 : standing_s_ + robot_.scan_period_s();
  return standing_s_ < kStandS;
}

DriveCommand DriveSession::CommandOf(const DriveWishes& wishes) {
  simulation::BodyVelocity velocity = {wishes.forward * setup_.options.follower.max_speed_m_s,
                                       wishes.left * setup_.options.follower.max_turn_rate_rad_s};
  if (follower_) velocity = follower_->Next(robot_.world_T_robot(), robot_.scan_period_s());
  return {velocity, odometry_noise_, slips_per_m_};
}

void DriveSession::GiveUpWhenBlocked() {
  if (!follower_) return;
  blocked_s_ = robot_.blocked_by() != nullptr ? blocked_s_ + robot_.scan_period_s() : 0.0;
  const bool gives_up = blocked_s_ > kPatienceS;
  if (gives_up) note_ = std::string("stopped: ") + robot_.blocked_by() + " is in the way";
  if (!gives_up && !follower_->Done()) return;
  follower_.reset();
  way_.clear();
}

void DriveSession::Replay(const std::vector<DriveCommand>& commands) {
  for (const DriveCommand& command : commands) {
    if (setup_.is_asked_to_stop()) return;
    tour_.Drive(command, &robot_);
  }
}

void DriveSession::Tick() {
  const DriveWishes wishes = controls_.Take();
  odometry_noise_ = wishes.odometry_noise;
  slips_per_m_ = wishes.slips_per_m;
  for (const int run : wishes.removed) RemoveVariant(run);
  for (const VariantChoice& choice : wishes.added) {
    try {
      note_.clear();
      AddVariant(choice);
    } catch (const std::exception& error) {
      note_ = error.what();
    }
  }
  if (wishes.goal) SetGoal(*wishes.goal);
  if (wishes.holds()) {
    follower_.reset();
    way_.clear();
    if (!was_held_) note_.clear();  // what is said while keys are held has to be read
  }
  was_held_ = wishes.holds();
  if (wishes.save) Save();
  const bool drives = Drives(wishes);
  if (drives) {
    tour_.Drive(CommandOf(wishes), &robot_);
    GiveUpWhenBlocked();
  }
  Publish(wishes.paused ? "paused" : drives ? "driving" : "waiting");
}

void DriveSession::Save() {
  if (tour_.steps() == 0) return;
  if (!setup_.save) {  // before maps are finished, and have to begin anew, for nothing
    note_ = "not saved: the program was started without --output_dir=DIR";
    return;
  }
  Publish("saving");
  VariantResults results;
  for (const auto& [run, variant] : variants_) {
    if (auto result = variant->Finish(setup_.is_asked_to_stop)) results[run] = std::move(result);
  }
  if (setup_.is_asked_to_stop()) return;
  standing_s_ = kStandS;  // maps that are finished stay until somebody drives on
  try {
    note_ = setup_.save(*this, results);
    saved_steps_ = tour_.steps();
    const std::size_t failed = variants_.size() - results.size();
    if (failed > 0) note_ += ", but for " + std::to_string(failed) + " of the maps: failed";
  } catch (const std::exception& error) {
    note_ = std::string("not saved: ") + error.what();
  }
}

void DriveSession::Publish(const std::string& state) {
  const Published now = {state, note_, tour_.steps(), way_.size(), odometry_noise_, slips_per_m_};
  const bool is_new = state != std::get<0>(published_);
  if (now == published_ || (!is_new && !truth_throttle_->Wants(server_))) return;
  published_ = now;
  const simulation::SimulationSummary summary = robot_.Summary();
  DriveStatus status{.state = state,
                     .note = note_,
                     .time_s = robot_.time_s(),
                     .path_m = summary.path_length_m,
                     .world_T_robot = robot_.world_T_robot(),
                     .world_T_odometry = setup_.title.world_T_start * robot_.odom_T_robot(),
                     .velocity = robot_.velocity(),
                     .blocked_by = robot_.blocked_by() ? robot_.blocked_by() : "",
                     .way = way_,
                     .walkers = {},
                     .odometry_noise = odometry_noise_,
                     .slips_per_m = slips_per_m_};
  if (setup_.scene.pedestrian) {
    status.walkers.push_back(setup_.scene.pedestrian->At(robot_.time_s()));
  }
  view::Snapshot snapshot;
  snapshot.figures.stamp_s = robot_.time_s();
  snapshot.figures.scans = static_cast<std::int64_t>(summary.world_T_robot.size());
  if (!summary.world_T_robot.empty()) {
    snapshot.figures.world_T_robot = summary.world_T_robot.back().world_T_robot;
    simulation::ScanPlayer player([&](const sensor::LaserScan& scan) { snapshot.scan = scan; });
    tour_.Play(tour_.steps() - 1, tour_.steps(), &player);
  } else {
    snapshot.figures.world_T_robot = setup_.title.world_T_start;
  }
  snapshot.graph =
      std::make_shared<const view::GraphSnapshot>(view::GraphSnapshot{summary.world_T_robot, {}});
  truth_throttle_->is_on_its_way = true;
  truth_throttle_->published = std::chrono::steady_clock::now();
  server_.Post([this, status = std::move(status), throttle = truth_throttle_,
                shared = std::make_shared<view::Snapshot>(std::move(snapshot))] {
    hub_.Apply(kTruthRun, std::move(*shared));
    hub_.SetStatus(status);
    throttle->is_on_its_way = false;
  });
}

void DriveSession::Run(double speed) {
  using Clock = std::chrono::steady_clock;
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(robot_.scan_period_s() / speed));
  Clock::time_point next = Clock::now();
  while (!setup_.is_asked_to_stop()) {
    Tick();
    next = std::max(next + period, Clock::now() - kFarBehind);  // what is lost is lost
    std::this_thread::sleep_until(next);
  }
}

}  // namespace gmapping_spa::drive
