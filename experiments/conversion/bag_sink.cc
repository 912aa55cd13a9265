// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/conversion/bag_sink.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "backend/graph/planar_quaternion.h"
#include "experiments/conversion/message_bytes.h"

namespace gmapping_spa::conversion {
namespace {

using sensor::Beam;
using sensor::BeamStatus;

// For lasers of which nothing is known.
constexpr float kLongestRange_m = 1000.0f;

std::int64_t Nanoseconds(double stamp_s) {
  return std::max<std::int64_t>(0, std::llround(static_cast<long double>(stamp_s) * 1e9L));
}

float RangeOf(const Beam& beam) {
  switch (beam.status) {
    case BeamStatus::kHit:
      return static_cast<float>(beam.range_m);
    case BeamStatus::kNoReturn:
      return std::numeric_limits<float>::infinity();
    case BeamStatus::kInvalid:
      break;
  }
  return std::numeric_limits<float>::quiet_NaN();
}

void PutPose(const backend::SE2& pose, MessageBytes* message) {
  const backend::PlanarQuaternion q = backend::QuaternionOf(backend::WrapAngle(pose.theta));
  for (const double value : {pose.x, pose.y, 0.0, 0.0, 0.0, q.qz, q.qw}) message->Put(value);
}

void PutZeros(int count, MessageBytes* message) {
  for (int i = 0; i < count; ++i) message->Put(0.0);
}

// Whether beams are as far apart as float32 can tell.
bool AreEven(const std::vector<Beam>& beams, double step_rad) {
  constexpr double kTolerance_rad = 1e-5;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double expected_rad = beams.front().angle_rad + static_cast<double>(i) * step_rad;
    if (std::abs(beams[i].angle_rad - expected_rad) > kTolerance_rad) return false;
  }
  return true;
}

}  // namespace

BagSink::BagSink(std::unique_ptr<BagWriter> writer)
    : writer_(std::move(writer)),
      tf_static_(writer_->AddTopic("/tf_static", "tf2_msgs/TFMessage")),
      odom_(writer_->AddTopic("/odom", "nav_msgs/Odometry")),
      scan_(writer_->AddTopic("/scan", "sensor_msgs/LaserScan")) {}

std::string BagSink::FrameOf(const backend::SE2& robot_T_laser, std::int64_t stamp_ns) {
  const auto found = std::ranges::find(mountings_, robot_T_laser);
  const auto number = found - mountings_.begin();
  std::string frame = "laser";
  if (number > 0) frame.append("_").append(std::to_string(number + 1));
  if (found != mountings_.end()) return frame;
  mountings_.push_back(robot_T_laser);
  MessageBytes message(writer_->encoding());
  message.Put(std::uint32_t{1}).Header(stamp_ns, "base_link").Text(frame);
  PutPose(robot_T_laser, &message);
  writer_->Write(tf_static_, stamp_ns, message.bytes());
  return frame;
}

void BagSink::OnScan(const sensor::ScanRecord& record) {
  const sensor::LaserScan& scan = record.scan;
  if (record.has_odometry) OnOdometry({scan.stamp_s, scan.odom_T_robot});
  const std::vector<Beam>& beams = scan.beams;
  const double gaps = static_cast<double>(std::max<std::size_t>(beams.size(), 2) - 1);
  // From beam to beam as the reader had it, which the whole of them would round.
  const double step_rad = (beams.back().angle_rad - beams.front().angle_rad) / gaps;
  if (!AreEven(beams, step_rad)) ++num_uneven_;
  const std::int64_t stamp_ns = Nanoseconds(scan.stamp_s);
  MessageBytes message(writer_->encoding());
  message.Header(stamp_ns, FrameOf(scan.robot_T_laser, stamp_ns));
  const float range_max_m =
      record.maximum_range_m > 0.0 ? static_cast<float>(record.maximum_range_m) : kLongestRange_m;
  for (const double value : {beams.front().angle_rad, beams.back().angle_rad, step_rad,
                             scan.sweep_s / gaps, 0.0, 0.0}) {  // the last: time, range_min
    message.Put(static_cast<float>(value));
  }
  message.Put(range_max_m);
  std::vector<float> ranges_m;
  for (const Beam& beam : beams) ranges_m.push_back(RangeOf(beam));
  message.Floats(ranges_m).Floats({});  // no intensities
  writer_->Write(scan_, stamp_ns, message.bytes());
}

void BagSink::OnOdometry(const sensor::OdometryRecord& record) {
  const std::int64_t stamp_ns = Nanoseconds(record.stamp_s);
  MessageBytes message(writer_->encoding());
  message.Header(stamp_ns, "odom").Text("base_link");
  PutPose(record.odom_T_robot, &message);
  PutZeros(36 + 6 + 36, &message);  // covariance, twist and its covariance are not known
  writer_->Write(odom_, stamp_ns, message.bytes());
}

Losses BagSink::losses() const {
  return {{"scans have beams at uneven angles, which were evened out", num_uneven_}};
}

}  // namespace gmapping_spa::conversion
