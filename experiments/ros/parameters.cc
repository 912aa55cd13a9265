// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/parameters.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "backend/text.h"

namespace gmapping_spa::ros {
namespace {

using Parameters = std::map<std::string, std::string>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Number(const std::string& name, const std::string& text, double min, double max) {
  const std::optional<double> value = backend::ParseFinite<double>(text);
  if (value && *value >= min && *value <= max) return *value;
  std::ostringstream message;
  message << "~" << name << ": expected a number from " << min << " to " << max << ", found "
          << backend::Quoted(text);
  throw std::runtime_error(message.str());
}

bool Truth(const std::string& name, const std::string& text) {
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  throw std::runtime_error("~" + name + ": expected true or false, found " + backend::Quoted(text));
}

std::string Flag(const std::string& name, double value) {
  std::ostringstream word;
  word.precision(std::numeric_limits<double>::max_digits10);
  word << "--" << name << "=" << value;
  return word.str();
}

// A parameter of slam_gmapping that is a flag here, in the same unit.
struct Renamed {
  const char* parameter;
  const char* flag;
};
constexpr Renamed kRenamed[] = {
    {"linearUpdate", "linear_update_m"},
    {"angularUpdate", "angular_update_rad"},
    {"resampleThreshold", "resample_threshold"},
    {"ogain", "obs_sigma_gain"},
    {"lstep", "match_linear_step_m"},
    {"astep", "match_angular_step_rad"},
    {"iterations", "match_refinements"},
    // As its program has them: the text of its page has srt and str the other way round.
    {"srt", "motion_angular_per_linear"},
    {"str", "motion_linear_per_angular"},
    {"stt", "motion_angular_per_angular"},
    {"delta", "resolution_m"},
    {"occ_thresh", "occupied_threshold"},
};

// One that has no counterpart. Up to the value `harmless` it asks for nothing that is not so
// anyway.
struct Refused {
  const char* parameter;
  double harmless;
  const char* reason;
};
constexpr const char* kGrows = "maps grow with what is seen";
constexpr const char* kSamples = "the likelihood of a pose is computed, not sampled";
constexpr Refused kRefused[] = {
    {"kernelSize", 1, "the end point of a beam is looked for in its cell and the 8 around it"},
    {"lskip", 0, "every beam counts"},
    {"temporalUpdate", 0, "motion decides when the filter is updated, not time"},
    {"xmin", -kInfinity, kGrows},
    {"ymin", -kInfinity, kGrows},
    {"xmax", -kInfinity, kGrows},
    {"ymax", -kInfinity, kGrows},
    {"llsamplerange", -kInfinity, kSamples},
    {"llsamplestep", -kInfinity, kSamples},
    {"lasamplerange", -kInfinity, kSamples},
    {"lasamplestep", -kInfinity, kSamples},
    {"inverted_laser", 0, "tf tells whether a laser is upside down, or the flag laser_flipped"},
};

// One that sets a member of NodeOptions.
using SetMember =
    std::function<void(const std::string& name, const std::string& text, NodeOptions*)>;
const std::map<std::string, SetMember>& NodeMembers() {
  static const auto& members = *new std::map<std::string, SetMember>{
      {"map_frame",
       [](auto& name, auto& text, auto* node) {
         node->map_frame = text.starts_with('/') ? text.substr(1) : text;
         if (node->map_frame.empty()) throw std::runtime_error("~" + name + ": expected a frame");
       }},
      {"throttle_scans",
       [](auto& name, auto& text, auto* node) {
         node->throttle_scans = static_cast<int>(Number(name, text, 1, 1e6));
       }},
      {"map_update_interval",
       [](auto& name, auto& text, auto* node) {
         node->map_update_interval_s = Number(name, text, 0, 1e9);
       }},
      {"transform_publish_period",
       [](auto& name, auto& text, auto* node) {
         node->transform_publish_period_s = Number(name, text, 0, 3600);
       }},
      {"tf_delay",
       [](auto& name, auto& text, auto* node) { node->tf_delay_s = Number(name, text, 0, 3600); }},
      {"minimumScore", [](auto& name, auto& text,
                          auto* node) { node->minimum_score = Number(name, text, 0, 1e6); }},
      {"queue_limit_mb", [](auto& name, auto& text,
                            auto* node) { node->queue_limit_mb = Number(name, text, 1e-3, 1e6); }},
      {"exit_on_time_jump",
       [](auto& name, auto& text, auto* node) { node->exit_on_time_jump = Truth(name, text); }},
  };
  return members;
}

// Beams from maxUrange to maxRange are cut at maxUrange and clear the map up to there; longer ones
// are left out.
void AddRanges(const Parameters& parameters, std::vector<std::string>* flags) {
  const auto max_urange = parameters.find("maxUrange"), max_range = parameters.find("maxRange");
  const auto value = [](const auto& found) {
    return Number(found->first, found->second, 0.01, 1e3);
  };
  if (max_urange != parameters.end()) {
    flags->push_back(Flag("usable_range_m", value(max_urange)));
    if (max_range != parameters.end() && value(max_range) > value(max_urange)) {
      flags->emplace_back("--no_return_clears");
    }
  } else if (max_range != parameters.end()) {
    flags->push_back(Flag("usable_range_m", value(max_range)));
  }
}

// Those whose values are converted. Returns whether `name` is one.
bool AddConverted(const std::string& name, const std::string& text,
                  std::vector<std::string>* flags) {
  if (name == "srr") {
    const double srr = Number(name, text, 0.0, 10.0);
    flags->push_back(Flag("motion_linear_per_linear", srr));
    flags->push_back(Flag("motion_lateral_per_linear", 0.3 * srr));
  } else if (name == "sigma" || name == "lsigma") {
    // A beam scores exp(-d^2 / sigma) there, exp(-d^2 / (2 sigma^2)) here.
    const double sigma_m = std::sqrt(Number(name, text, 1e-6, 1e4) / 2.0);
    flags->push_back(Flag(name == "sigma" ? "score_sigma_m" : "likelihood_sigma_m", sigma_m));
  } else {
    return false;
  }
  return true;
}

bool IsFlag(const std::string& name, const apps::FlagGroups& groups) {
  return name == "flagfile" || std::ranges::any_of(groups, [&](const apps::FlagGroup& group) {
           return std::ranges::count(group.flags, name) > 0;
         });
}

// A flag that the command line would refuse is named as the parameter that it is: it may be left
// over on the parameter server from a node before.
void CheckType(const std::string& name, const std::string& text) {
  gflags::CommandLineFlagInfo info;
  if (name == "flagfile" || !gflags::GetCommandLineFlagInfo(name.c_str(), &info)) return;
  const gflags::FlagSaver saver;
  if (!gflags::SetCommandLineOption(name.c_str(), text.c_str()).empty()) return;
  throw std::runtime_error("~" + name + ": expected a value of type " + info.type + ", found " +
                           backend::Quoted(text));
}

}  // namespace

NodeParameters ReadParameters(const Parameters& parameters, const apps::FlagGroups& flag_groups) {
  NodeParameters read;
  AddRanges(parameters, &read.flags);
  for (const auto& [name, text] : parameters) {
    const auto is_named = [&name = name](const auto& known) { return name == known.parameter; };
    if (name == "maxUrange" || name == "maxRange") continue;
    if (AddConverted(name, text, &read.flags)) continue;
    if (const auto member = NodeMembers().find(name); member != NodeMembers().end()) {
      member->second(name, text, &read.node);
    } else if (const auto* renamed = std::ranges::find_if(kRenamed, is_named);
               renamed != std::end(kRenamed)) {
      read.flags.push_back(Flag(renamed->flag, Number(name, text, -1e9, 1e9)));
    } else if (const auto* refused = std::ranges::find_if(kRefused, is_named);
               refused != std::end(kRefused)) {
      const bool asks = name == "inverted_laser"
                            ? Truth(name, text)
                            : Number(name, text, -1e9, 1e9) > refused->harmless;
      if (asks) read.refusals.push_back("~" + name + " is not used: " + refused->reason);
    } else if (IsFlag(name, flag_groups)) {
      CheckType(name, text);
      read.flags.push_back(std::string("--").append(name).append("=").append(text));
    } else {
      read.refusals.push_back("~" + name + " is not used: neither slam_gmapping nor gmapping_spa " +
                              "has a parameter of that name");
    }
  }
  return read;
}

}  // namespace gmapping_spa::ros
