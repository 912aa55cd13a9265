// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/bag_reader.h"

#include <glog/logging.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "backend/text.h"
#include "frontend/rosbag/packed_message.h"
#include "frontend/rosbag/scan_beams.h"
#include "frontend/rosbag/unpack.h"
#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::rosbag {
namespace {

using backend::SE2;
using sensor::MalformedRecord;
using sensor::ScanRecord;

// What is latched, as /tf_static, is recorded within the first second or so.
constexpr double kLongestWait_s = 10.0;
constexpr std::size_t kMostHeld = 4096;
constexpr double kTolerance = 1e-2;  // m and rad, of laser poses that are the same
constexpr double kTilted_rad = 0.1;

// A double has no room for nanoseconds since 1970; what is nearest to them is taken.
double Seconds(std::int64_t time_ns) {
  return static_cast<double>(static_cast<long double>(time_ns) / 1e9L);
}

bool IsSame(const SE2& a, const SE2& b) {
  const SE2 difference = Between(a, b);
  return difference.translation().norm() <= kTolerance && std::abs(difference.theta) <= kTolerance;
}

const char* UseOf(MessageType type) {
  switch (type) {
    case MessageType::kLaserScan:
    case MessageType::kMultiEchoLaserScan:
      return "scans";
    case MessageType::kOdometry:
      return "odometry";
    case MessageType::kTf:
      return "transforms";
    case MessageType::kOther:
      break;
  }
  return "";
}

}  // namespace

BagReader::BagReader(std::unique_ptr<MessageSource> source, std::string name,
                     const sensor::LogOptions& options, std::shared_ptr<BagReport> report)
    : source_(std::move(source)),
      name_(std::move(name)),
      options_(options),
      report_(std::move(report)),
      choice_(ChooseTopics(source_->contents(), name_, options)),
      tf_odometry_(options.odom_frame),
      frames_(options.base_frame) {
  const BagContents& contents = source_->contents();
  if (options_.bad_record == sensor::BadRecordPolicy::kFail && contents.unclosed) {
    throw std::runtime_error(name_ + ": expected a bag that was closed, found one without an " +
                             "index, whose last " + std::to_string(contents.cut_off_bytes) +
                             " bytes are no whole record");
  }
  std::vector<bool> wanted;
  for (const MessageType type : choice_.use) wanted.push_back(type != MessageType::kOther);
  source_->Select(wanted);
  BeginReport();
}

void BagReader::BeginReport() {
  const BagContents& contents = source_->contents();
  report_->format = contents.format;
  report_->first_s = Seconds(contents.first_ns);
  report_->last_s = Seconds(contents.last_ns);
  for (std::size_t i = 0; i < contents.topics.size(); ++i) {
    const BagTopic& topic = contents.topics[i];
    report_->topics.push_back({topic.name, topic.type, topic.messages, UseOf(choice_.use[i])});
    if (choice_.use[i] == MessageType::kOdometry) report_->odometry_from = topic.name;
  }
  if (options_.robot_T_laser) {
    report_->lasers.push_back({"", *options_.robot_T_laser, false, 0.0, "--laser_pose"});
  }
}

std::optional<sensor::LogRecord> BagReader::Next() {
  while (held_.empty() && Read()) {
  }
  if (held_.empty()) {
    if (num_scans_ > 0) {
      if (!first_malformed_.empty()) LOG(WARNING) << "left out: " << first_malformed_;
      first_malformed_.clear();
      return std::nullopt;
    }
    throw std::runtime_error(name_ + ": no laser scans found (" + std::to_string(num_malformed_) +
                             " malformed messages" +
                             (num_malformed_ > 0 ? ", the first: " + first_malformed_ : "") + ")");
  }
  // References to elements of a deque outlive push_back.
  Held& held = held_.front();
  if (auto* scan = std::get_if<ScanRecord>(&held.record)) {
    if (!options_.robot_T_laser) Mount(held.frame, scan);
  } else if (!options_.base_frame.empty() && choice_.has_tf) {
    auto& odometry = std::get<sensor::OdometryRecord>(held.record);
    Decide(held.frame);
    odometry.odom_T_robot =
        odometry.odom_T_robot * Inverse(mountings_.at(held.frame).robot_T_frame);
  }
  sensor::LogRecord record = std::move(held.record);
  held_.pop_front();
  return record;
}

sensor::LogCounts BagReader::counts() const {
  const BagContents& contents = source_->contents();
  return {{"messages", num_messages_},
          {"scan_records", num_scans_},
          {"odometry_records", num_odometry_},
          {"transforms", num_transforms_},
          {"malformed_records", num_malformed_},
          {"stamps_of_recording", num_unstamped_},
          {"laser_pose_assumed", num_assumed_poses_},
          {"laser_pose_other_base", num_other_bases_},
          {"laser_pose_changes", num_changed_poses_},
          {"laser_tilted", num_tilted_},
          {"several_scan_topics", choice_.scan_topics},
          {"several_odometry_topics", choice_.odometry_topics},
          {"unclosed_bag", contents.unclosed ? 1 : 0},
          {"cut_off_bytes", contents.cut_off_bytes},
          {"missing_files", contents.missing_files}};
}

bool BagReader::Read() {
  std::optional<BagMessage> message = source_->Next();
  if (!message) {
    at_end_ = true;
    return false;
  }
  ++num_messages_;
  newest_ns_ = message->time_ns;
  std::string unpacked;
  try {
    // rosbag2 packs messages by themselves when told to; plain CDR begins with a zero.
    if (source_->contents().topics[message->topic].encoding == Encoding::kCdr &&
        IsZstd(message->data)) {
      unpacked =
          UnpackMessage(*message, MostUnpackedBytes(source_->contents().bytes) - unpacked_bytes_);
      unpacked_bytes_ += unpacked.size();
      message->data = unpacked;
    }
    Take(*message);
  } catch (const MalformedRecord& malformed) {
    LeaveOut(*message, malformed.what());
  }
  return true;
}

void BagReader::LeaveOut(const BagMessage& message, const std::string& reason) {
  const bool fails = options_.bad_record == sensor::BadRecordPolicy::kFail;
  if (++num_malformed_ > 1 && !fails) return;
  first_malformed_ =
      *message.file + ": " + message.unit + " " + std::to_string(message.place) + ": topic " +
      backend::Printable(source_->contents().topics[message.topic].name + ": " + reason);
  if (fails) throw std::runtime_error(first_malformed_);
}

void BagReader::Take(const BagMessage& message) {
  switch (choice_.use[message.topic]) {
    case MessageType::kLaserScan:
    case MessageType::kMultiEchoLaserScan:
      return TakeScan(message);
    case MessageType::kOdometry:
      return TakeOdometry(message);
    case MessageType::kTf:
      return TakeTf(message);
    case MessageType::kOther:
      return;
  }
}

void BagReader::TakeScan(const BagMessage& message) {
  const LaserScanMessage scan = ParseLaserScan(
      message.data, source_->contents().topics[message.topic].encoding, choice_.use[message.topic]);
  ScanRecord record;
  record.line = message.place;
  record.scan.beams = BeamsOf(scan, options_);
  record.scan.sweep_s = SweepOf(scan);
  if (scan.range_max_m > 0.0) record.maximum_range_m = scan.range_max_m;
  record.scan.robot_T_laser = options_.robot_T_laser.value_or(SE2{});
  record.scan.stamp_s = Stamp(scan.header, message);
  ++num_scans_;
  held_.push_back({std::move(record), scan.header.frame_id, message.time_ns});
}

void BagReader::TakeOdometry(const BagMessage& message) {
  const OdometryMessage odometry =
      ParseOdometry(message.data, source_->contents().topics[message.topic].encoding);
  frames_.SetOdometryFrame(odometry.child_frame_id);
  const sensor::OdometryRecord record{Stamp(odometry.header, message), odometry.odom_T_child};
  ++num_odometry_;
  held_.push_back({record, odometry.child_frame_id, message.time_ns});
}

void BagReader::TakeTf(const BagMessage& message) {
  for (const TransformMessage& transform :
       ParseTf(message.data, source_->contents().topics[message.topic].encoding)) {
    ++num_transforms_;
    if (transform.header.frame_id == transform.child_frame_id) {  // which tf leaves out as well
      LeaveOut(message, "expected a transform between two frames, found one of '" +
                            transform.child_frame_id + "' to itself");
      continue;
    }
    tree_.Set(transform.header.frame_id, transform.child_frame_id, transform.parent_T_child);
    if (!choice_.odometry_from_tf || !tf_odometry_.Is(transform)) continue;
    report_->odometry_from = "tf " + tf_odometry_.name();
    frames_.SetOdometryFrame(transform.child_frame_id);
    const sensor::OdometryRecord record{Stamp(transform.header, message),
                                        InPlane(transform.parent_T_child)};
    ++num_odometry_;
    held_.push_back({record, transform.child_frame_id, message.time_ns});
  }
}

double BagReader::Stamp(const MessageHeader& header, const BagMessage& message) {
  if (header.stamp_ns != 0) return Seconds(header.stamp_ns);
  ++num_unstamped_;
  return Seconds(message.time_ns);
}

bool BagReader::MayWait() const {
  return choice_.has_tf && !at_end_ && held_.size() < kMostHeld &&
         Seconds(newest_ns_) - Seconds(held_.front().time_ns) < kLongestWait_s;
}

std::optional<Mounting> BagReader::Find(const std::string& frame, bool may_assume) const {
  try {
    if (may_assume) return frames_.FindOrAssume(tree_, frame);
    return frames_.Find(tree_, frame);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name_ + ": " + error.what());
  }
}

bool BagReader::Decide(const std::string& frame) {
  const auto known = mountings_.find(frame);
  if (known != mountings_.end() && !known->second.base_frame.empty()) return false;
  std::optional<Mounting> mounting = Find(frame, false);
  if (known != mountings_.end() && !mounting) return false;
  while (!mounting && MayWait()) {
    Read();
    mounting = Find(frame, false);
  }
  if (!mounting) mounting = Find(frame, true);
  report_->base_frame = frames_.base_frame().empty() ? mounting->base_frame : frames_.base_frame();
  mountings_[frame] = *mounting;
  return true;
}

void BagReader::Mount(const std::string& frame, ScanRecord* record) {
  const bool is_new = Decide(frame);
  const Mounting& mounting = mountings_.at(frame);
  if (is_new) {
    report_->lasers.push_back({frame, mounting.robot_T_frame, mounting.upside_down,
                               mounting.tilt_rad, mounting.base_frame.empty() ? "assumed" : "tf"});
  }
  record->scan.robot_T_laser = mounting.robot_T_frame;
  if (mounting.upside_down) {
    for (sensor::Beam& beam : record->scan.beams) beam.angle_rad = -beam.angle_rad;
  }
  if (mounting.base_frame.empty()) ++num_assumed_poses_;
  const std::string& robot = frames_.base_frame();
  if (!mounting.base_frame.empty() && !robot.empty() && mounting.base_frame != robot) {
    ++num_other_bases_;
  }
  if (mounting.tilt_rad > kTilted_rad) ++num_tilted_;
  const std::optional<Mounting> now = Find(frame, false);
  if (now && !IsSame(now->robot_T_frame, mounting.robot_T_frame)) ++num_changed_poses_;
}

}  // namespace gmapping_spa::rosbag
