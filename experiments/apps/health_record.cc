// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/health_record.h"

#include <glog/logging.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace gmapping_spa::apps {
namespace {

using frontend::Finding;
using frontend::Stretch;

struct CountMeaning {
  const char* count;
  const char* message;
};

// Counts of what is as it should be (records read, ODOM interpolated, ...) are not among them.
constexpr CountMeaning kMeanings[] = {
    {"malformed_records",
     "records could not be read and were left out (--bad_record=fail ends at the first)"},
    {"unknown_records", "records of an unknown type were left out"},
    {"late_scans", "scans are older than --reorder_window_s allows: was the clock set back?"},
    {"out_of_order_scans", "scans were not in order of time and were put in order"},
    {"duplicate_stamps", "scans have the stamp of the scan before"},
    {"gaps", "times between scans are longer than --gap_s"},
    {"changed_beam_counts", "scans have another number of beams than the scan before"},
    {"assumed_field_of_view",
     "scans do not tell their field of view: the usual one of their number of beams was taken "
     "(--fov_deg overrides)"},
    {"max_range_readings",
     "readings are the longest of the log, which occurs again and again: the maximum range of the "
     "laser, taken for no return"},
    {"beams_on_robot",
     "readings are short and do not change while the robot turns: the robot itself, left out "
     "(--range_min_m leaves out more)"},
    {"laser_pose_used",
     "scans have the mounting of the laser that the laser poses of the records agree on "
     "(--laser_pose overrides)"},
    {"laser_pose_mismatches",
     "records have a laser pose that contradicts the mounting of the laser (--laser_pose sets it)"},
    {"laser_pose_assumed",
     "scans are of a laser of which no transform tells where it is: it is taken to be where the "
     "robot is (--laser_pose sets it)"},
    {"laser_pose_other_base",
     "scans are of a laser that transforms tell relative to base_link or base_footprint only: that "
     "is taken for the frame of the odometry (--base_frame names another)"},
    {"laser_pose_changes",
     "scans are of a laser that transforms see elsewhere than at first: it is taken to stay there"},
    {"laser_tilted", "scans are of a laser that is tilted; it is taken to be level"},
    {"stamps_of_recording",
     "messages have no stamp in their header: the time at which they were recorded was taken"},
    {"several_scan_topics",
     "topics have scans: /scan was taken (--scan_topic names another, inspect_log lists them)"},
    {"several_odometry_topics",
     "topics have odometry: /odom was taken (--odometry_topic names another, inspect_log lists "
     "them)"},
    {"unclosed_bag",
     "bag was not closed by its recorder: it was read through for what its index would tell"},
    {"cut_off_bytes", "bytes at the end of the bag are no whole record and were left out"},
    {"missing_files", "files that metadata.yaml lists are not there"},
    {"scans_without_odometry", "scans have no odometry"},
    {"odometry_extrapolated", "scans are before or after all odometry and got the nearest one"},
};

Finding Untimed(const std::string& message, std::int64_t count) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {message, nan, nan, count};
}

Json ToJson(const Finding& finding) {
  Json json = {{"message", finding.message}, {"count", finding.count}};
  if (std::isfinite(finding.first_stamp_s)) json["first_s"] = finding.first_stamp_s;
  if (std::isfinite(finding.last_stamp_s)) json["last_s"] = finding.last_stamp_s;
  return json;
}

Finding Summarize(const std::string& kind, const std::vector<Stretch>& stretches) {
  return {"stretches of time marked as " + kind, stretches.front().begin_s, stretches.back().end_s,
          static_cast<std::int64_t>(stretches.size())};
}

}  // namespace

std::int64_t CountOf(const sensor::LogCounts& counts, const std::string& name) {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : found->second;
}

Findings FindingsOf(const sensor::LogCounts& counts) {
  Findings findings;
  for (const auto& [name, message] : kMeanings) {
    const std::int64_t count = CountOf(counts, name);
    if (count > 0) findings.emplace(name, Untimed(message, count));
  }
  // A few beams end within the range even where all are in another unit.
  constexpr std::int64_t kFewestHitsIn = 50;
  const std::int64_t hits = CountOf(counts, "beams_hit");
  const std::int64_t beams =
      hits + CountOf(counts, "beams_no_return") + CountOf(counts, "beams_invalid");
  if (hits * kFewestHitsIn < beams) {
    findings.emplace("few_hits",
                     Untimed("beams ended on something, out of " + std::to_string(beams) +
                                 ": are ranges in cm or mm, or is --usable_range_m too short?",
                             hits));
  }
  return findings;
}

void WarnOf(const sensor::LogCounts& counts) {
  for (const auto& [kind, finding] : FindingsOf(counts)) {
    LOG(WARNING) << kind << ": " << finding.count << ' ' << finding.message;
  }
}

Json ToJson(Findings findings, const Stretches& all_stretches) {
  for (const auto& [kind, stretches] : all_stretches) {
    findings.emplace(kind, Summarize(kind, stretches));
  }
  Json json = Json::object();
  for (const auto& [kind, finding] : findings) json[kind] = ToJson(finding);
  for (const auto& [kind, stretches] : all_stretches) {
    Json& list = json[kind]["stretches"] = Json::array();
    for (const Stretch& stretch : stretches) list.push_back({stretch.begin_s, stretch.end_s});
  }
  return json;
}

Json HealthRecord(const frontend::Health& health, const sensor::LogCounts& counts) {
  Findings findings = FindingsOf(counts);
  findings.insert(health.findings().begin(), health.findings().end());
  return ToJson(std::move(findings), health.stretches());
}

}  // namespace gmapping_spa::apps
