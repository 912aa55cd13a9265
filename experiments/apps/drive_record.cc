// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/drive_record.h"

#include <filesystem>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include "backend/enum_names.h"
#include "backend/graph/trajectory_io.h"
#include "experiments/apps/json.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/slam_option_names.h"
#include "experiments/apps/version.h"
#include "experiments/drive/drive_state.h"
#include "experiments/simulation/carmen_writer.h"
#include "frontend/map/map_building.h"
#include "frontend/map/map_server_io.h"

namespace gmapping_spa::apps {
namespace {

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json RecordOf(const drive::VariantChoice& choice, const drive::VariantResult& result,
              const std::string& name) {
  return {{"backend", choice.backend},
          {"particles", choice.particles},
          {"correction", backend::NameOf(kCorrectionNames, choice.correction)},
          {"trajectory", name + ".tum"},
          {"map", name + ".yaml"},
          {"ate_m", OrNull(result.score.ate_m)},
          {"iou", OrNull(result.score.iou)}};
}

std::string VariantName(int run) { return "variant_" + std::to_string(run); }

// Those of an earlier save with more maps, of which drive.json tells nothing any more.
void RemoveOtherVariants(const drive::VariantResults& results, const std::string& folder) {
  for (int run = drive::kTruthRun + 1; run <= drive::kMaxVariants; ++run) {
    if (results.contains(run)) continue;
    for (const char* extension : {".tum", ".pgm", ".yaml"}) {
      const std::filesystem::path path =
          std::filesystem::path(folder) / (VariantName(run) + extension);
      std::error_code error;
      std::filesystem::remove(path, error);
      if (!error) continue;
      throw std::runtime_error("cannot remove '" + path.string() +
                               "' of an earlier save: " + error.message());
    }
  }
}

}  // namespace

std::string WriteDrive(const SimulationSetup& setup, const drive::DriveSession& session,
                       const drive::VariantResults& results, double occupied_threshold,
                       const std::string& folder) {
  OutputFiles files(folder);
  const drive::RecordedTour& tour = session.tour();
  const simulation::SimulationSummary summary = session.robot().Summary();
  files.Write("log.clf", [&](std::ostream& out) {
    simulation::CarmenWriter writer(out);
    tour.Play(0, tour.steps(), &writer);
  });
  WriteTruth(setup, summary, &files);
  files.Write("commands.csv", [&](std::ostream& out) { tour.WriteCommands(out); });
  Json variants = Json::array();
  for (const auto& [run, choice] : session.variants()) {
    const auto found = results.find(run);
    if (found == results.end()) continue;
    const std::string name = VariantName(run);
    const frontend::SlamResult& estimate = found->second->result;
    const map::TrinaryMap map = map::BuildTrinaryMap(estimate.map, occupied_threshold);
    files.Write(name + ".tum",
                [&](std::ostream& out) { backend::WriteTum(estimate.trajectory, out); });
    files.Write(name + ".pgm", [&](std::ostream& out) { map::WritePgm(map, out); });
    files.Write(name + ".yaml",
                [&](std::ostream& out) { map::WriteMapYaml(map, name + ".pgm", out); });
    variants.push_back(RecordOf(choice, *found->second, name));
  }
  const Json record = {{"program", ReleaseVersion()},
                       {"scans", summary.world_T_robot.size()},
                       {"path_length_m", summary.path_length_m},
                       {"slips", summary.slips},
                       {"bumps", summary.bumps},
                       {"variants", variants}};
  files.Write("drive.json", [&](std::ostream& out) { out << TextOf(record) << '\n'; });
  files.Commit();
  RemoveOtherVariants(results, folder);
  return std::to_string(summary.world_T_robot.size()) + " scans saved in " + folder;
}

}  // namespace gmapping_spa::apps
