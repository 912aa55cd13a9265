// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/renamed_flags.h"

#include <map>
#include <stdexcept>

namespace gmapping_spa::apps {
namespace {

const std::map<std::string, std::string>& NewNames() {
  static const std::map<std::string, std::string> names = {
      {"closure_max_second_score", "closure_max_runner_up_score"},
      {"closure_min_fit", "closure_min_inlier_ratio"},
      {"closure_min_way_m", "closure_min_path_length_m"},
      {"final_round", "final_optimization"},
      {"full_threshold", "grid_occupied_threshold"},
      {"match_halvings", "match_refinements"},
      {"spa_max_rises", "spa_max_nonmonotonic_steps"}};
  return names;
}

}  // namespace

void RefuseFormerName(const std::string& place, const std::string& flag) {
  std::string name = flag.substr(0, flag.find('='));
  if (!NewNames().contains(name) && name.starts_with("no")) name.erase(0, 2);
  const auto found = NewNames().find(name);
  if (found == NewNames().end()) return;
  throw std::runtime_error(place + ": --" + name + " is called --" + found->second + " now");
}

}  // namespace gmapping_spa::apps
