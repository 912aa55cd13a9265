// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/bag_inspection.h"

#include <numbers>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::apps {
namespace {

std::string Fixed(const Json& number, int decimals) {
  return backend::FixedText(number.get<double>(), decimals);
}

std::string Text(const Json& text) { return backend::Printable(text.get<std::string>()); }

}  // namespace

Json BagToJson(const rosbag::BagReport& bag) {
  const double duration_s = bag.last_s - bag.first_s;
  Json topics = Json::array(), lasers = Json::array();
  for (const rosbag::BagReport::Topic& topic : bag.topics) {
    topics.push_back(
        {{"name", topic.name},
         {"type", topic.type},
         {"messages", topic.messages},
         {"rate_hz", duration_s > 0.0 ? static_cast<double>(topic.messages) / duration_s : 0.0},
         {"used_for", topic.used_for}});
  }
  for (const rosbag::BagReport::Laser& laser : bag.lasers) {
    lasers.push_back({{"frame", laser.frame},
                      {"x_m", laser.robot_T_laser.x},
                      {"y_m", laser.robot_T_laser.y},
                      {"theta_rad", laser.robot_T_laser.theta},
                      {"upside_down", laser.upside_down},
                      {"tilt_deg", laser.tilt_rad * 180.0 / std::numbers::pi},
                      {"from", laser.from}});
  }
  return {
      {"format", bag.format}, {"first_s", bag.first_s},       {"duration_s", duration_s},
      {"topics", topics},     {"base_frame", bag.base_frame}, {"odometry_from", bag.odometry_from},
      {"lasers", lasers}};
}

void PrintBag(const Json& bag, std::ostream& out) {
  out << "\n"
      << Text(bag["format"]) << ", " << Fixed(bag["duration_s"], 1) << " s from "
      << Fixed(bag["first_s"], 3) << " s on:\n";
  for (const Json& topic : bag["topics"]) {
    const std::string use = Text(topic["used_for"]);
    out << "  " << Text(topic["name"]) << ": " << topic["messages"] << " messages, "
        << Fixed(topic["rate_hz"], 2) << " a second, " << Text(topic["type"])
        << (use.empty() ? "" : ": read for " + use) << '\n';
  }
  const std::string base = Text(bag["base_frame"]), odometry = Text(bag["odometry_from"]);
  out << "  frame of the robot: " << (base.empty() ? "not told" : base)
      << "; odometry from: " << (odometry.empty() ? "nothing" : odometry) << '\n';
  for (const Json& laser : bag["lasers"]) {
    out << "  laser " << Text(laser["frame"]) << " at x " << Fixed(laser["x_m"], 3) << " m, y "
        << Fixed(laser["y_m"], 3) << " m, " << Fixed(laser["theta_rad"], 4) << " rad"
        << (laser["upside_down"] ? ", upside down" : "") << ", tilted by "
        << Fixed(laser["tilt_deg"], 1) << " deg: by " << Text(laser["from"]) << '\n';
  }
}

}  // namespace gmapping_spa::apps
