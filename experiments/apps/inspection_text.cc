// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/inspection_text.h"

#include <algorithm>
#include <iomanip>

#include "backend/text.h"
#include "experiments/apps/bag_inspection.h"

namespace gmapping_spa::apps {
namespace {

std::string Fixed(const Json& number, int decimals) {
  return backend::FixedText(number.get<double>(), decimals);
}

std::string Percent(const Json& share) { return Fixed(100.0 * share.get<double>(), 1) + " %"; }

void PrintRanges(const Json& ranges, std::ostream& out) {
  out << "\nRanges: " << Percent(ranges["hit_share"]) << " of the beams end between "
      << Fixed(ranges["range_min_m"], 2) << " and " << Fixed(ranges["usable_range_m"], 1) << " m, "
      << Percent(ranges["no_return_share"]) << " have no return, "
      << Percent(ranges["invalid_share"]) << " are invalid\n";
  const Json& hits = ranges["hits_by_meter"];
  if (hits.empty()) return;
  out << "  from " << Fixed(ranges["shortest_hit_m"], 2) << " to "
      << Fixed(ranges["longest_hit_m"], 2) << " m:\n";
  constexpr double kBarLength = 50.0;
  const double most = *std::max_element(hits.begin(), hits.end());
  for (std::size_t meter = 0; meter < hits.size(); ++meter) {
    const auto bar = static_cast<std::size_t>(kBarLength * hits[meter].get<double>() / most);
    out << std::setw(5) << meter << " m " << std::setw(9) << hits[meter] << ' '
        << std::string(bar, '#') << '\n';
  }
}

void PrintSteps(const char* title, const Json& steps, std::ostream& out) {
  if (steps.empty()) return;
  out << "  " << title << ":\n";
  for (const Json& step : steps) {
    const std::string fault = step["fault"];
    out << "    at " << Fixed(step["stamp_s"], 3) << " s: " << Fixed(step["length_m"], 3) << " m, "
        << Fixed(step["turn_deg"], 1) << " deg within " << Fixed(step["elapsed_s"], 3) << " s"
        << (fault == "none" ? "" : " (" + fault + ")") << '\n';
  }
}

void PrintOdometry(const Json& odometry, std::ostream& out) {
  out << "\nOdometry: of " << odometry["scans"] << " scans, " << Fixed(odometry["path_m"], 1)
      << " m driven, unchanged at " << odometry["unchanged_steps"] << " steps\n";
  PrintSteps("longest steps", odometry["longest_steps"], out);
  PrintSteps("largest turns", odometry["largest_turns"], out);
}

// As a run warns of the same.
void PrintHealth(const Json& health, std::ostream& out) {
  out << "\nHealth, as run.json would have it:\n";
  if (health.empty()) out << "  nothing stands out\n";
  for (const auto& [kind, finding] : health.items()) {
    out << "  " << kind << ": " << finding["count"];
    if (finding.contains("first_s")) {
      out << " times from " << Fixed(finding["first_s"], 3) << " s to "
          << Fixed(finding["last_s"], 3) << " s:";
    }
    out << ' ' << finding["message"].get<std::string>() << '\n';
    if (!finding.contains("stretches")) continue;
    for (const Json& stretch : finding["stretches"]) {
      out << "    from " << Fixed(stretch[0], 3) << " s to " << Fixed(stretch[1], 3) << " s\n";
    }
  }
}

}  // namespace

void PrintInspection(const std::string& name, const Json& report, std::ostream& out) {
  out << name << ": " << report["scans"] << " scans in " << Fixed(report["duration_s"], 1)
      << " s, from " << Fixed(report["first_stamp_s"], 3)
      << " s on: " << Fixed(report["rate_hz"], 2) << " a second, mostly "
      << Fixed(report["median_period_s"], 3) << " s apart, at most "
      << Fixed(report["longest_period_s"], 3) << " s\n";
  if (report.contains("bag")) PrintBag(report["bag"], out);
  out << "\nRecords:\n";
  for (const auto& [kind, count] : report["records"].items()) {
    if (count != 0) out << "  " << kind << ": " << count << '\n';
  }
  out << "\nLaser:\n";
  for (const Json& count : report["beam_counts"]) {
    out << "  " << count["scans"] << " scans of " << count["beams"] << " beams\n";
  }
  const Json &fov = report["field_of_view"], &pose = report["laser_pose"];
  out << "  from " << Fixed(fov["first_deg"], 2) << " to " << Fixed(fov["last_deg"], 2) << " deg, "
      << (fov["assumed"] ? "assumed from the number of beams" : "as the log or the flags say")
      << "\n  at x " << Fixed(pose["x_m"], 3) << " m, y " << Fixed(pose["y_m"], 3) << " m, "
      << Fixed(pose["theta_rad"], 4) << " rad on the robot, by " << pose["from"].get<std::string>()
      << '\n';
  PrintRanges(report["ranges"], out);
  PrintOdometry(report["odometry"], out);
  PrintHealth(report["health"], out);
  if (!report["advice"].empty()) out << "\nAdvice:\n";
  for (const Json& line : report["advice"]) out << "  - " << line.get<std::string>() << '\n';
}

}  // namespace gmapping_spa::apps
