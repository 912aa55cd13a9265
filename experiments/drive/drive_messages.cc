// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/drive_messages.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "backend/enum_names.h"
#include "experiments/apps/slam_option_names.h"
#include "experiments/view/client_message.h"
#include "experiments/view/json_values.h"

namespace gmapping_spa::drive {
namespace {

using nlohmann::json;
using view::Dumped, view::Millimeters, view::PoseJson, view::Rounded, view::Seconds;

const char* CorrectionName(SlamOptions::Correction correction) {
  return backend::NameOf(apps::kCorrectionNames, correction);
}

json RunJson(const std::string& name, int run, double resolution_m) {
  return {{"name", name}, {"run", run}, {"live", true}, {"resolution_m", resolution_m}};
}

// x and y in turn.
json PointsJson(const simulation::WayPoints& points) {
  json values = json::array();
  for (const Eigen::Vector2d& point : points) {
    values.push_back(Millimeters(point.x()));
    values.push_back(Millimeters(point.y()));
  }
  return values;
}

json WalkerJson(const simulation::Rectangle& walker) {
  return {{"pose", PoseJson(walker.world_T_center)},
          {"half_size", {walker.half_size_m.x(), walker.half_size_m.y()}}};
}

json OrNull(const std::optional<double>& value, double scale) {
  return value ? Rounded(*value, scale) : json();
}

double NumberOf(const json& message, const char* name, double min, double max) {
  const auto value = message.find(name);
  if (value == message.end() || !value->is_number()) {
    throw std::runtime_error(std::string("expected a number ") + name);
  }
  const double number = value->get<double>();
  if (!(number >= min && number <= max)) {
    throw std::runtime_error(std::string(name) + " is out of its range");
  }
  return number;
}

std::string TextOf(const json& message, const char* name) {
  const auto value = message.find(name);
  if (value == message.end() || !value->is_string()) {
    throw std::runtime_error(std::string("expected a text ") + name);
  }
  return value->get<std::string>();
}

VariantChoice ChoiceOf(const json& message, const DriveTitle& title) {
  VariantChoice choice;
  choice.backend = TextOf(message, "backend");
  // A page names no file of this machine.
  if (std::find(title.backends.begin(), title.backends.end(), choice.backend) ==
      title.backends.end()) {
    throw std::runtime_error("expected one of the back ends that were told");
  }
  choice.particles = static_cast<int>(NumberOf(message, "particles", 1, kMaxParticles));
  const auto correction = backend::ValueOf(apps::kCorrectionNames, TextOf(message, "correction"));
  if (!correction) throw std::runtime_error("expected a correction");
  choice.correction = *correction;
  return choice;
}

}  // namespace

std::string NameOf(const VariantChoice& choice) {
  return choice.backend + ", " + std::to_string(choice.particles) +
         (choice.particles == 1 ? " particle, " : " particles, ") +
         CorrectionName(choice.correction);
}

view::MessagePtr HelloMessage(const std::string& session, const DriveTitle& title,
                              const VariantStatuses& variants) {
  json runs = json::array({RunJson("truth", kTruthRun, title.truth_resolution_m)});
  for (const auto& [run, variant] : variants) {
    runs.push_back(RunJson(NameOf(variant.choice), run, title.map_resolution_m));
  }
  json corrections = json::array();
  for (const auto& entry : apps::kCorrectionNames) corrections.push_back(entry.name);
  return Dumped({{"op", "hello"},
                 {"session", session},
                 {"world", title.world},
                 {"world_T_start", PoseJson(title.world_T_start)},
                 {"robot_radius_m", title.robot_radius_m},
                 {"backends", title.backends},
                 {"corrections", std::move(corrections)},
                 {"max_variants", kMaxVariants},
                 {"max_particles", kMaxParticles},
                 {"runs", std::move(runs)}});
}

view::MessagePtr StatusMessage(const DriveStatus& status) {
  json walkers = json::array();
  for (const simulation::Rectangle& walker : status.walkers) walkers.push_back(WalkerJson(walker));
  return Dumped(
      {{"op", "status"},
       {"state", status.state},
       {"note", status.note},
       {"time_s", Seconds(status.time_s)},
       {"path_m", Millimeters(status.path_m)},
       {"pose", PoseJson(status.world_T_robot)},
       {"odometry", PoseJson(status.world_T_odometry)},
       {"velocity",
        {Millimeters(status.velocity.linear_m_s), Millimeters(status.velocity.angular_rad_s)}},
       {"blocked_by", status.blocked_by},
       {"way", PointsJson(status.way)},
       {"walkers", std::move(walkers)},
       {"noise", status.odometry_noise},
       {"slips", status.slips_per_m}});
}

view::MessagePtr VariantsMessage(const VariantStatuses& variants) {
  json list = json::array();
  for (const auto& [run, variant] : variants) {
    list.push_back({{"run", run},
                    {"name", NameOf(variant.choice)},
                    {"state", variant.state},
                    {"scored_s", Seconds(variant.score.stamp_s)},
                    {"ate_m", OrNull(variant.score.ate_m, 1e4)},
                    {"iou", OrNull(variant.score.iou, 1e4)}});
  }
  return Dumped({{"op", "variants"}, {"list", std::move(list)}});
}

view::MessagePtr ScoresMessage(int run, const VariantStatus& variant) {
  json rows = json::array();
  for (const MapScore& score : variant.scores.rows()) {
    rows.push_back({Seconds(score.stamp_s), OrNull(score.ate_m, 1e4), OrNull(score.iou, 1e4)});
  }
  return Dumped({{"op", "scores"}, {"run", run}, {"rows", std::move(rows)}});
}

void TakeWish(std::string_view data, bool is_binary, const DriveTitle& title,
              DriveControls* controls) {
  const json message = view::ParseClientMessage(data, is_binary);
  const std::string op = message.at("op").get<std::string>();
  if (op == "hold") {
    const double forward = NumberOf(message, "forward", -1.0, 1.0);
    const double left = NumberOf(message, "left", -1.0, 1.0);
    controls->Hold(forward, left);
  } else if (op == "goal") {
    const Eigen::Vector2d goal(NumberOf(message, "x", -1e6, 1e6),
                               NumberOf(message, "y", -1e6, 1e6));
    controls->Update([&](DriveWishes* wishes) { wishes->goal = goal; });
  } else if (op == "odometry") {
    const double noise = NumberOf(message, "noise", 0.0, 1000.0);
    const double slips_per_m = NumberOf(message, "slips", 0.0, 1000.0);
    controls->Update([&](DriveWishes* wishes) {
      wishes->odometry_noise = noise;
      wishes->slips_per_m = slips_per_m;
    });
  } else if (op == "pause" || op == "resume") {
    controls->Update([&](DriveWishes* wishes) { wishes->paused = op == "pause"; });
  } else if (op == "save") {
    controls->Update([](DriveWishes* wishes) { wishes->save = true; });
  } else if (op == "add") {
    const VariantChoice choice = ChoiceOf(message, title);
    controls->Update([&](DriveWishes* wishes) {
      if (wishes->added.size() < kMaxVariants) wishes->added.push_back(choice);
    });
  } else if (op == "remove") {
    const int run = static_cast<int>(NumberOf(message, "run", 1, kMaxVariants));
    controls->Update([&](DriveWishes* wishes) {
      if (wishes->removed.size() < kMaxVariants) wishes->removed.push_back(run);
    });
  } else {
    throw std::runtime_error("expected another op");
  }
}

}  // namespace gmapping_spa::drive
