// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/slam_node_core.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "backend/se2.h"
#include "experiments/apps/health_record.h"
#include "experiments/ros/live_reader.h"
#include "experiments/ros/live_source.h"
#include "experiments/ros/node_flags.h"
#include "experiments/ros/node_slam.h"
#include "frontend/rosbag/ros_messages.h"

namespace gmapping_spa::ros {
namespace {

using backend::SE2;

constexpr std::int64_t kJump_ns = 1'000'000'000;  // farther back than clocks are corrected
constexpr std::chrono::seconds kGrace(10);

std::string OdomFrame() {
  const std::string frame = LogOptionsOfNode().odom_frame;
  if (frame.empty()) throw std::runtime_error("--odom_frame: expected the frame of the odometry");
  return frame.front() == '/' ? frame.substr(1) : frame;
}

class Core : public SlamNodeCore {
 public:
  Core(const NodeOptions& options, rosbag::Encoding encoding, NodeOutput* output);
  ~Core() override;

  void TakeScan(std::string_view data, std::int64_t time_ns) override;
  void TakeTf(std::string_view data, std::int64_t time_ns) override;
  void CountLost(std::int64_t scans) override;
  void SetStartPose(const std::string& frame, const SpatialPose& map_T_robot) override;
  std::optional<PlanarPose> map_T_odom() const override;
  OldMap old_map() const override;
  const std::string& odom_frame() const override { return odom_frame_; }
  ScanCounts counts() const override;
  bool failed() const override;
  void SaveSession() override;
  void Finish() override;

 private:
  bool Accepts(std::int64_t time_ns);
  void Work();
  void Use(const sensor::LaserScan& scan);
  void ShowWhatIsDue();
  void TakePose(const std::optional<SE2>& world_T_robot, const sensor::LaserScan& scan);
  void SayFindings();
  void Stop();

  const NodeOptions options_;
  const std::string odom_frame_;
  NodeOutput* const output_;
  LiveSource source_;
  std::unique_ptr<sensor::LogReader> reader_;  // of the thread
  std::mutex slam_mutex_;                      // taken before mutex_
  NodeSlam slam_;
  const bool has_old_map_;
  std::map<std::string, std::int64_t> said_;  // findings

  mutable std::mutex mutex_;  // of what follows
  ScanCounts counts_;
  std::chrono::steady_clock::time_point scan_came_ = std::chrono::steady_clock::now();  // the last
  std::int64_t newest_ns_ = 0;
  bool time_jumped_ = false;
  std::string error_;
  SE2 map_T_world_;
  std::optional<SE2> map_T_odom_;
  bool is_found_ = false;  // in the old map

  std::thread thread_;  // last, as it uses all others
};

Core::Core(const NodeOptions& options, rosbag::Encoding encoding, NodeOutput* output)
    : options_(options),
      odom_frame_(OdomFrame()),
      output_(output),
      source_(encoding, static_cast<std::size_t>(options.queue_limit_mb * 1e6)),
      reader_(MakeLiveReader(&source_)),
      slam_(options.map_update_interval_s, options.minimum_score),
      has_old_map_(slam_.has_old_map()),
      thread_([this] { Work(); }) {}

Core::~Core() { Stop(); }

bool Core::Accepts(std::int64_t time_ns) {
  if (!time_jumped_ && time_ns < newest_ns_ - kJump_ns) {
    time_jumped_ = true;
    const std::string jump = "the clock went back by " +
                             std::to_string(static_cast<double>(newest_ns_ - time_ns) * 1e-9) +
                             " s: no more messages are used, restart the node for a new map";
    if (options_.exit_on_time_jump) error_ = jump;
    output_->Say(Severity::kError, jump);
  }
  newest_ns_ = std::max(newest_ns_, time_ns);
  return !time_jumped_;
}

void Core::TakeScan(std::string_view data, std::int64_t time_ns) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t number = counts_.received++;
  scan_came_ = std::chrono::steady_clock::now();
  if (!Accepts(time_ns)) {
    ++counts_.after_time_jump;
  } else if (number % options_.throttle_scans != 0) {
    ++counts_.throttled;
  } else if (!source_.Give(LiveSource::kScan, data, time_ns) && ++counts_.refused == 1) {
    output_->Say(Severity::kWarning,
                 "the SLAM does not keep up: scans are left out, as those that wait take all of "
                 "~queue_limit_mb");
  }
}

void Core::TakeTf(std::string_view data, std::int64_t time_ns) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!Accepts(time_ns) || source_.Give(LiveSource::kTf, data, time_ns)) return;
  if (++counts_.transforms_refused == 1) {
    output_->Say(
        Severity::kWarning,
        "the SLAM does not keep up: transforms are left out, as those that wait take all of "
        "~queue_limit_mb");
  }
}

void Core::CountLost(std::int64_t scans) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (counts_.lost == 0) {
    output_->Say(Severity::kWarning,
                 "scans were lost on the way to this node: their numbers have gaps");
  }
  counts_.lost += scans;
}

void Core::SetStartPose(const std::string& frame, const SpatialPose& map_T_robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto refuse = [&](const std::string& reason) {
    output_->Say(Severity::kWarning, "the start pose is not used: " + reason);
  };
  if (has_old_map_) {
    return refuse(
        "the robot is looked for in all of the map of ~map_session, and what it sees decides where "
        "it is");
  }
  if (counts_.used > 0) {
    return refuse(
        "the first scan has fixed the map frame, and a SLAM does not relocate in its map");
  }
  if (frame != options_.map_frame && frame != "/" + options_.map_frame) {
    return refuse("expected one in the frame '" + options_.map_frame + "', found '" + frame + "'");
  }
  const SpatialPose& pose = map_T_robot;
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() =
      Eigen::Quaterniond(pose.qw, pose.qx, pose.qy, pose.qz).normalized().toRotationMatrix();
  isometry.translation() = Eigen::Vector3d(pose.x_m, pose.y_m, pose.z_m);
  const SE2 planar = rosbag::InPlane(isometry);
  if (!planar.IsFinite()) return refuse("expected finite numbers");
  map_T_world_ = planar;
  output_->Say(Severity::kInfo, "the start pose is used");
  if (planar.theta == 0.0) return;
  output_->Say(Severity::kWarning,
               "the map will be turned: info.origin of /map has a heading, which many programs do "
               "not look at");
}

std::optional<PlanarPose> Core::map_T_odom() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!map_T_odom_) return std::nullopt;
  return Planar(*map_T_odom_);
}

OldMap Core::old_map() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!has_old_map_) return OldMap::kNone;
  return is_found_ ? OldMap::kFound : OldMap::kSearched;
}

ScanCounts Core::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  ScanCounts counts = counts_;
  counts.waiting = source_.waiting_scans();
  counts.silent_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - scan_came_).count();
  return counts;
}

bool Core::failed() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !error_.empty();
}

void Core::Work() {
  try {
    if (has_old_map_) ShowWhatIsDue();  // which is there before the first scan
    while (const std::optional<sensor::LaserScan> scan = reader_->Next()) {
      Use(*scan);
      SayFindings();
    }
  } catch (const std::exception& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    // A node that is stopped before the first scan has nothing to complain of.
    if (counts_.received > 0) error_ = error.what();
  }
}

void Core::Use(const sensor::LaserScan& scan) {
  {
    const std::lock_guard<std::mutex> slam_lock(slam_mutex_);
    const std::optional<SE2> world_T_robot = slam_.AddScan(scan);
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.used;
    TakePose(world_T_robot, scan);
  }
  ShowWhatIsDue();
}

void Core::ShowWhatIsDue() {
  const std::lock_guard<std::mutex> slam_lock(slam_mutex_);
  SE2 map_T_world;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    map_T_world = map_T_world_;
  }
  if (const std::optional<Snapshot> snapshot = slam_.DueSnapshot(map_T_world)) {
    output_->Show(*snapshot);
  }
}

void Core::TakePose(const std::optional<SE2>& world_T_robot, const sensor::LaserScan& scan) {
  if (has_old_map_ && is_found_ != world_T_robot.has_value()) {
    is_found_ = !is_found_;
    output_->Say(is_found_ ? Severity::kInfo : Severity::kWarning,
                 is_found_ ? "the robot is found in the map of ~map_session"
                           : "the robot is looked for anew in the map of ~map_session: until it is "
                             "found, there is no map -> odom");
  }
  if (!world_T_robot) {
    map_T_odom_.reset();
  } else if (scan.has_odometry) {
    map_T_odom_ = map_T_world_ * *world_T_robot * backend::Inverse(scan.odom_T_robot);
  }
}

void Core::SayFindings() {
  for (const auto& [kind, finding] : apps::FindingsOf(reader_->counts())) {
    if (said_[kind]++ == 0) output_->Say(Severity::kWarning, kind + ": " + finding.message);
  }
}

void Core::SaveSession() {
  const std::lock_guard<std::mutex> lock(slam_mutex_);
  slam_.SaveSession();
}

void Core::Stop() {
  source_.Close(kGrace);
  if (thread_.joinable()) thread_.join();
}

void Core::Finish() {
  Stop();
  const ScanCounts counts = this->counts();
  apps::Json json;
  for (const auto& [name, value] : NamedCounts(counts)) json[name] = value;
  output_->Say(Severity::kInfo, "scans: " + json.dump());
  if (!IsComplete(counts) || counts.waiting > 0) {
    output_->Say(Severity::kWarning, "not all scans are in the map: " + json.dump());
  }
  slam_.Finish(reader_->counts(), [&] { return apps::Json{{"live_scans", json}}; });
  if (!error_.empty()) throw std::runtime_error(error_);
}

}  // namespace

std::unique_ptr<SlamNodeCore> MakeSlamNodeCore(const NodeOptions& options,
                                               Serialization serialization, NodeOutput* output) {
  const bool is_ros1 = serialization == Serialization::kRos1;
  return std::make_unique<Core>(options, is_ros1 ? rosbag::Encoding::kRos1 : rosbag::Encoding::kCdr,
                                output);
}

}  // namespace gmapping_spa::ros
