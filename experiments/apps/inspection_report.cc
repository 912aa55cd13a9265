// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/inspection_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "experiments/apps/bag_inspection.h"
#include "experiments/apps/health_record.h"

namespace gmapping_spa::apps {
namespace {

using sensor::OdometryFault;

double Degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

// Robots drive less than this between two scans that shall be matched.
constexpr double kLongStepM = 1.0, kLongStepRad = 0.5;
constexpr double kFewBeams = 60, kNarrowRad = std::numbers::pi * 0.9;
constexpr std::size_t kLargestSteps = 5;

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Json StepToJson(const OdometryStep& step) {
  return {{"stamp_s", step.stamp_s},
          {"elapsed_s", step.elapsed_s},
          {"length_m", step.length_m},
          {"turn_deg", Degrees(step.turn_rad)},
          {"fault", sensor::OdometryFaultName(step.fault)}};
}

template <typename Less>
Json LargestSteps(std::vector<OdometryStep> steps, Less less) {
  const std::size_t count = std::min(steps.size(), kLargestSteps);
  std::partial_sort(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(count), steps.end(),
                    [&](const auto& a, const auto& b) { return less(b, a); });
  Json json = Json::array();
  for (std::size_t i = 0; i < count; ++i) json.push_back(StepToJson(steps[i]));
  return json;
}

Json Odometry(const LogSummary& summary) {
  double length_m = 0.0;
  std::int64_t unchanged = 0;
  for (const OdometryStep& step : summary.steps) {
    if (step.fault == OdometryFault::kUnchanged) ++unchanged;
    if (step.fault == OdometryFault::kNone || step.fault == OdometryFault::kRepeatedScan) {
      length_m += step.length_m;
    }
  }
  return {{"scans", summary.scans_with_odometry},
          {"path_m", length_m},
          {"unchanged_steps", unchanged},
          {"longest_steps",
           LargestSteps(summary.steps,
                        [](const auto& a, const auto& b) { return a.length_m < b.length_m; })},
          {"largest_turns", LargestSteps(summary.steps, [](const auto& a, const auto& b) {
             return a.turn_rad < b.turn_rad;
           })}};
}

// With the keys of a run's health, since a run would report the same.
Json HealthOf(const LogSummary& summary, const sensor::LogCounts& counts) {
  Findings findings = FindingsOf(counts);
  findings.insert(summary.findings.begin(), summary.findings.end());
  if (summary.silent.empty()) return ToJson(std::move(findings), {});
  std::int64_t scans = 0;
  for (const frontend::Stretch& stretch : summary.silent) scans += stretch.scans;
  findings["odometry_silent"] = {"the odometry stands still while the scans change",
                                 summary.silent.front().begin_s, summary.silent.back().end_s,
                                 scans};
  return ToJson(std::move(findings), {{"odometry_silent", summary.silent}});
}

std::string MountingSource(const sensor::LogCounts& counts, const sensor::LogOptions& options,
                           const rosbag::BagReport* bag) {
  if (options.robot_T_laser) return "--laser_pose";
  if (bag != nullptr && !bag->lasers.empty()) {
    return bag->lasers.front().from == "tf" ? "the transforms"
                                            : "default, as no transform tells it";
  }
  return CountOf(counts, "laser_pose_used") > 0 ? "the laser poses of the records"
                                                : "the log, or by default";
}

// Beyond what is wrong: what makes SLAM hard.
std::vector<std::string> Advice(const LogSummary& summary, double fov_rad, std::size_t beams) {
  std::vector<std::string> advice;
  const bool constant = std::ranges::all_of(summary.steps, [](const OdometryStep& step) {
    return step.fault == OdometryFault::kUnchanged;
  });
  if (constant && !summary.steps.empty()) {
    advice.emplace_back("the odometry is the same throughout: it is as good as none");
  }
  const auto long_steps =
      std::count_if(summary.steps.begin(), summary.steps.end(), [](const OdometryStep& step) {
        return step.fault == OdometryFault::kNone &&
               (step.length_m > kLongStepM || step.turn_rad > kLongStepRad);
      });
  if (long_steps > 0) {
    advice.push_back(std::to_string(long_steps) +
                     " times the robot moves by more than 1 m or 0.5 rad from scan to scan: more "
                     "scans would make the map surer");
  }
  if (static_cast<double>(beams) < kFewBeams) {
    advice.push_back("scans of " + std::to_string(beams) + " beams bind a pose weakly");
  }
  if (fov_rad < kNarrowRad) {
    advice.push_back("a field of view below 180 deg makes turns hard to follow");
  }
  return advice;
}

}  // namespace

Json InspectionReport(const LogSummary& summary, const sensor::LogCounts& counts,
                      const sensor::LogOptions& options, const rosbag::BagReport* bag) {
  const std::vector<double>& periods_s = summary.periods_s;
  const double duration_s = summary.last_stamp_s - summary.first_stamp_s;
  const auto usual =
      std::max_element(summary.scans_by_beams.begin(), summary.scans_by_beams.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  Json beam_counts = Json::array();
  for (const auto& [beams, scans] : summary.scans_by_beams) {
    beam_counts.push_back({{"beams", beams}, {"scans", scans}});
  }
  const double beams = static_cast<double>(counts.at("beams_hit") + counts.at("beams_no_return") +
                                           counts.at("beams_invalid"));
  const double fov_rad = std::abs(summary.last_beam_rad - summary.first_beam_rad);
  const backend::SE2& laser = summary.robot_T_laser;
  Json report = {
      {"records", counts},
      {"scans", summary.scans},
      {"first_stamp_s", summary.first_stamp_s},
      {"duration_s", duration_s},
      {"rate_hz", duration_s > 0.0 ? static_cast<double>(summary.scans - 1) / duration_s : 0.0},
      {"median_period_s", Median(periods_s)},
      {"longest_period_s",
       periods_s.empty() ? 0.0 : *std::max_element(periods_s.begin(), periods_s.end())},
      {"beam_counts", beam_counts},
      {"field_of_view",
       {{"first_deg", Degrees(summary.first_beam_rad)},
        {"last_deg", Degrees(summary.last_beam_rad)},
        {"assumed", CountOf(counts, "assumed_field_of_view") > 0}}},
      {"ranges",
       {{"hit_share", static_cast<double>(counts.at("beams_hit")) / beams},
        {"no_return_share", static_cast<double>(counts.at("beams_no_return")) / beams},
        {"invalid_share", static_cast<double>(counts.at("beams_invalid")) / beams},
        {"range_min_m", options.range_min_m},
        {"usable_range_m", options.usable_range_m},
        {"shortest_hit_m", summary.shortest_hit_m},
        {"longest_hit_m", summary.longest_hit_m},
        {"hits_by_meter", summary.hits_by_meter}}},
      {"laser_pose",
       {{"x_m", laser.x},
        {"y_m", laser.y},
        {"theta_rad", laser.theta},
        {"from", MountingSource(counts, options, bag)}}},
      {"odometry", Odometry(summary)},
      {"health", HealthOf(summary, counts)},
      {"advice", Advice(summary, fov_rad, usual->first)}};
  if (bag != nullptr) report["bag"] = BagToJson(*bag);
  return report;
}

}  // namespace gmapping_spa::apps
