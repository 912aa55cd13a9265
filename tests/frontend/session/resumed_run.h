// SPDX-License-Identifier: BSD-3-Clause
// Runs that are saved in the middle and gone on with in another object.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_SESSION_RESUMED_RUN_H_
#define GMAPPING_SPA_TESTS_FRONTEND_SESSION_RESUMED_RUN_H_

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "backend/graph/g2o_io.h"
#include "backend/graph/trajectory_io.h"
#include "backend/spa/spa_optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/map/map_building.h"
#include "frontend/map/map_server_io.h"
#include "frontend/session/state.h"
#include "frontend/slam_parts.h"

namespace gmapping_spa::session {

using Scans = std::vector<sensor::LaserScan>;

inline SlamOptions QuickOptions() {
  SlamOptions options;
  options.particles = 3;
  options.linear_update_m = 0.5;
  options.optimize_every = 10;
  options.graph_timeout_s = 60.0;  // under the sanitizers too
  return options;
}

inline std::unique_ptr<frontend::ImprovedGmapping> MakeGmapping(const SlamOptions& options) {
  auto spa = std::make_shared<spa::SpaOptimizer>();
  auto gmapping = std::make_unique<frontend::ImprovedGmapping>(
      frontend::GmappingOptions(options), frontend::MakeScanMatcher(options),
      frontend::BindOptimizer(options, spa));
  gmapping->KeepStateOf(spa);
  return gmapping;
}

// Finishes the run.
inline std::string ResultOf(frontend::ImprovedGmapping* gmapping) {
  const frontend::SlamResult result = gmapping->Finish();
  std::ostringstream out;
  backend::WriteTum(result.trajectory, out);
  backend::WriteG2o(result.graph, out);
  map::WritePgm(map::BuildTrinaryMap(result.map, 0.25), out);
  out << gmapping->counts().corrections << ' ' << gmapping->counts().pieces << ' '
      << gmapping->counts().resamplings << ' ' << gmapping->graph_thread().counts().started << ' '
      << gmapping->graph_thread().counts().taken << ' ' << gmapping->loop_closer().records().size();
  for (const auto& [kind, finding] : gmapping->health().findings()) {
    out << '\n' << kind << ' ' << finding.count << ' ' << finding.message;
  }
  return out.str();
}

// Saves a run before each of the scans `cuts`, goes on from there and expects the bytes of the run
// that was not interrupted. Returns the latter.
inline std::unique_ptr<frontend::ImprovedGmapping> ExpectSameWhenResumed(
    const SlamOptions& options, const Scans& scans, const std::vector<std::size_t>& cuts) {
  auto whole = MakeGmapping(options);
  std::map<std::size_t, std::string> states;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for (const std::size_t cut : cuts) {
      if (cut == k) states[k] = SaveState(*whole);
    }
    whole->AddScan(scans[k]);
  }
  const std::string expected = ResultOf(whole.get());
  for (const auto& [cut, state] : states) {
    auto resumed = MakeGmapping(options);
    LoadState(state, resumed.get());
    EXPECT_TRUE(SaveState(*resumed) == state) << "at scan " << cut;
    for (std::size_t k = cut; k < scans.size(); ++k) resumed->AddScan(scans[k]);
    EXPECT_TRUE(ResultOf(resumed.get()) == expected) << "from scan " << cut;
  }
  return whole;
}

}  // namespace gmapping_spa::session

#endif  // GMAPPING_SPA_TESTS_FRONTEND_SESSION_RESUMED_RUN_H_
