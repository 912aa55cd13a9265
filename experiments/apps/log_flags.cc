// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/log_flags.h"

#include <gflags/gflags.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "experiments/apps/flag_checks.h"

namespace {

using gmapping_spa::sensor::BadRecordPolicy;

const gmapping_spa::sensor::LogOptions kDefaults;
constexpr gmapping_spa::backend::EnumName<BadRecordPolicy> kBadRecord[] = {
    {"skip", BadRecordPolicy::kSkip}, {"fail", BadRecordPolicy::kFail}};

}  // namespace

DEFINE_double(usable_range_m, kDefaults.usable_range_m,
              "Usable range of the laser in m, from 0.01 to 1000: a range this long or longer "
              "counts as no return.");
DEFINE_double(range_min_m, kDefaults.range_min_m,
              "Least range of the laser in m, from 0 to --usable_range_m: a beam with a shorter "
              "range is left out as invalid.");
DEFINE_string(fov_deg, "",
              "Field of view of the laser in degrees, -360 to 360, from the first beam to the "
              "last. Empty: that of the log.");
DEFINE_string(angle_min_deg, "",
              "Angle of the first beam in the laser's frame in degrees, -360 to 360. Empty: that "
              "of the log.");
DEFINE_string(laser_pose, "",
              "Pose x,y,theta (m, m, rad) of the laser in the robot's frame, within 100 m and one "
              "turn. Empty: that of the log (of a bag: what the transforms say).");
DEFINE_bool(laser_flipped, kDefaults.flipped,
            "The laser is mounted upside down: beam angles change their sign. Where the transforms "
            "of a bag say that it is, they change once more.");
DEFINE_double(reorder_window_s, kDefaults.reorder_window_s,
              "Time in s, from 0 to 1e6, by which a record of the log may be late and is still put "
              "in the order of stamps; a later one is taken for a clock that was set back.");
DEFINE_double(
    gap_s, kDefaults.gap_s,
    "Time in s, above 0, between two scans above which it is counted and reported as a gap.");
DEFINE_string(bad_record, NameOf(kBadRecord, kDefaults.bad_record),
              "What to do about records of the log that cannot be used: skip (and count them) or "
              "fail (at the first one, with its line number).");
DEFINE_string(scan_topic, "",
              "Topic of a bag with the laser scans. Empty: the only one with such, or /scan.");
DEFINE_string(
    odometry_topic, "",
    "Topic of a bag with the odometry; one of transforms (/tf) takes it from these. Empty: "
    "the only one with nav_msgs/Odometry, or /odom, or without any the transforms.");
DEFINE_string(base_frame, "",
              "Frame of the robot in a bag, whose poses are wanted. Empty: that of the odometry.");
DEFINE_string(odom_frame, "",
              "Frame of the odometry in a bag, where the transforms tell it. Empty: odom, or one "
              "with that in its name.");

namespace gmapping_spa::apps {
namespace {

constexpr double kMaxOffsetM = 100.0;  // of a laser from the middle of its robot

std::optional<double> OptionalRadians(const char* flag, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::optional<double> degrees = backend::ParseFinite<double>(text);
  if (!degrees || std::abs(*degrees) > 360.0) {
    FailFlag(flag, text, "expected degrees, at most one turn");
  }
  return *degrees * std::numbers::pi / 180.0;
}

std::optional<backend::SE2> OptionalLaserPose() {
  if (FLAGS_laser_pose.empty()) return std::nullopt;
  const std::vector<double> pose = Numbers("laser_pose", FLAGS_laser_pose);
  if (pose.size() != 3 || std::abs(pose[0]) > kMaxOffsetM || std::abs(pose[1]) > kMaxOffsetM ||
      std::abs(pose[2]) > 2.0 * std::numbers::pi) {
    FailFlag("laser_pose", FLAGS_laser_pose, "expected x,y,theta within 100 m and one turn");
  }
  return backend::SE2{pose[0], pose[1], pose[2]};
}

}  // namespace

FlagGroups LogFlagGroups() {
  return {{"log",
           "Sensor log",
           {"usable_range_m", "range_min_m", "fov_deg", "angle_min_deg", "laser_pose",
            "laser_flipped", "reorder_window_s", "gap_s", "bad_record", "scan_topic",
            "odometry_topic", "base_frame", "odom_frame"}}};
}

sensor::LogOptions LogOptionsFromFlags() {
  sensor::LogOptions options;
  options.usable_range_m = InRange("usable_range_m", FLAGS_usable_range_m, 0.01, 1000.0);
  options.range_min_m = InRange("range_min_m", FLAGS_range_min_m, 0.0, options.usable_range_m);
  options.fov_rad = OptionalRadians("fov_deg", FLAGS_fov_deg);
  options.angle_min_rad = OptionalRadians("angle_min_deg", FLAGS_angle_min_deg);
  options.robot_T_laser = OptionalLaserPose();
  options.flipped = FLAGS_laser_flipped;
  options.reorder_window_s = InRange("reorder_window_s", FLAGS_reorder_window_s, 0.0, 1e6);
  options.gap_s = InRange("gap_s", FLAGS_gap_s, 1e-6, 1e12);
  options.bad_record = OneOf("bad_record", FLAGS_bad_record, kBadRecord);
  options.scan_topic = FLAGS_scan_topic;
  options.odometry_topic = FLAGS_odometry_topic;
  options.base_frame = FLAGS_base_frame;
  options.odom_frame = FLAGS_odom_frame;
  return options;
}

}  // namespace gmapping_spa::apps
