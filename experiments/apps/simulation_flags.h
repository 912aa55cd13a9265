// SPDX-License-Identifier: BSD-3-Clause
// Flags of the simulated robot, for every executable that runs it.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SIMULATION_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SIMULATION_FLAGS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "experiments/apps/flag_groups.h"
#include "experiments/apps/output_files.h"
#include "experiments/simulation/simulation.h"

namespace gmapping_spa::apps {

FlagGroups SimulationFlagGroups();

// A world, a tour of it and a robot.
struct SimulationSetup {
  std::map<std::string, std::string> input_files;  // by their flags: world, path, obstacles
  simulation::Scene scene;
  simulation::WayPoints way_points;
  simulation::SimulationOptions options;
  map::TrinaryMap truth;
  std::optional<map::TrinaryMap> obstacles;  // of --obstacles what stands: `truth` of it alone
};

// Throws std::runtime_error with one line when a flag or a file makes no sense.
SimulationSetup SimulationFromFlags(std::uint64_t seed);

// Writes truth.tum, truth.pgm and truth.yaml; with obstacles truth_obstacles.pgm and
// truth_obstacles.yaml as well.
void WriteTruth(const SimulationSetup& setup, const simulation::SimulationSummary& summary,
                OutputFiles* files);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SIMULATION_FLAGS_H_
