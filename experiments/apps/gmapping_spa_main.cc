// Runs SLAM on a sensor log and writes trajectory, map, picture, pose graph and run record.
#include <gflags/gflags.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "backend/g2o_io.h"
#include "experiments/apps/app.h"
#include "experiments/apps/backend_flags.h"
#include "experiments/apps/closure_table.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/log_flags.h"
#include "experiments/apps/map_picture.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/progress_bar.h"
#include "experiments/apps/run_record.h"
#include "experiments/apps/slam_flags.h"
#include "frontend/improved_gmapping.h"
#include "frontend/map/map_building.h"
#include "frontend/map/map_server_io.h"
#include "frontend/sensor/open_log.h"

DEFINE_string(log, "", "Sensor log (CARMEN), plain or gzipped.");
DEFINE_string(output_dir, "", "Folder for the results; made if needed.");

namespace gmapping_spa::apps {
namespace {

struct Slam {
  double occupied_threshold = OccupiedThresholdFromFlags();
  frontend::ImprovedGmapping gmapping;
  std::optional<frontend::Estimate> estimate;

  Slam()
      : gmapping(SlamOptionsFromFlags(), ScanMatcherFromFlags(),
                 [optimizer = std::shared_ptr<backend::Optimizer>(LoadOptimizerFromFlags())](
                     backend::PoseGraph* g) { return OptimizeAsFlagsSay(optimizer.get(), g); }) {}
};

std::int64_t CountLines(const std::string& path) {
  const std::unique_ptr<std::istream> in = OpenInput(path);
  return std::count(std::istreambuf_iterator<char>(*in), {}, '\n');
}

sensor::LogCounts ProcessLog(const sensor::LogOptions& options,
                             frontend::ImprovedGmapping* gmapping) {
  ProgressBar progress("slam", CountLines(FLAGS_log));
  const std::unique_ptr<sensor::LogReader> reader =
      sensor::OpenCarmenLog(OpenInput(FLAGS_log), FLAGS_log, options);
  while (const std::optional<sensor::LaserScan> scan = reader->Next()) {
    ThrowIfInterrupted();
    gmapping->AddScan(*scan);
    progress.Update(reader->counts().at("lines"));
  }
  return reader->counts();
}

void WriteResults(const Slam& slam, const sensor::LogCounts& log_counts, Stopwatch* stopwatch,
                  OutputFiles* files) {
  const frontend::Estimate& estimate = slam.estimate.value();
  const backend::Trajectory& trajectory = estimate.trajectory;
  const map::TrinaryMap map = map::BuildTrinaryMap(estimate.map, slam.occupied_threshold);
  backend::Trajectory by_time = trajectory;
  std::stable_sort(by_time.begin(), by_time.end(),
                   [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });

  files->Write("trajectory.tum", [&](std::ostream& out) { backend::WriteTum(trajectory, out); });
  files->Write("map.pgm", [&](std::ostream& out) { map::WritePgm(map, out); });
  files->Write("map.yaml", [&](std::ostream& out) { map::WriteMapYaml(map, "map.pgm", out); });
  files->Write("graph.g2o", [&](std::ostream& out) { backend::WriteG2o(estimate.graph, out); });
  files->Write("loop_closures.csv", [&](std::ostream& out) {
    WriteClosures(slam.gmapping.loop_closer().records(), estimate.graph.nodes, out);
  });
  WriteMapPicture(map, by_time, files->TemporaryPath("map.png"));
  stopwatch->Lap("writing_s");
  const Json record =
      MakeRunRecord(IdentifyFile(FLAGS_log), log_counts, slam.gmapping, map, *stopwatch);
  files->Write("run.json", [&](std::ostream& out) { out << record.dump(2) << '\n'; });
}

void Run() {
  if (FLAGS_log.empty()) throw std::runtime_error("--log=FILE is missing");
  if (FLAGS_output_dir.empty()) throw std::runtime_error("--output_dir=DIR is missing");
  // Pipes would be empty when they are read again: for the progress and for the hash.
  if (std::filesystem::exists(FLAGS_log) && !std::filesystem::is_regular_file(FLAGS_log) &&
      !std::filesystem::is_directory(FLAGS_log)) {
    throw std::runtime_error(FLAGS_log + ": expected a regular file, which can be read repeatedly");
  }
  OptionsFromFlags();  // complains now, not in the graph thread
  Stopwatch stopwatch;
  const sensor::LogOptions log_options = LogOptionsFromFlags();
  Slam slam;
  OutputFiles files(FLAGS_output_dir);
  const sensor::LogCounts log_counts = ProcessLog(log_options, &slam.gmapping);
  stopwatch.Lap("processing_s");
  slam.estimate = slam.gmapping.Finish();
  stopwatch.Lap("finish_s");
  WriteResults(slam, log_counts, &stopwatch, &files);
  ThrowIfInterrupted();
  files.Commit();
  const frontend::ImprovedGmapping::Counts& counts = slam.gmapping.counts();
  std::cout << counts.scans << " scans, " << counts.updates << " updates, " << counts.resamplings
            << " resamplings; results in " << FLAGS_output_dir << '\n';
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  // Closures found by a machine are never beyond doubt; those in files may have been checked.
  gflags::SetCommandLineOptionWithMode("loss", "huber", gflags::SET_FLAGS_DEFAULT);
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "makes a map and a trajectory from a sensor log.\n"
      "Usage: gmapping_spa --log=FILE --output_dir=DIR [--flagfile=FILE] [flags]\n"
      "Writes trajectory.tum, map.pgm, map.yaml, map.png, graph.g2o, loop_closures.csv and "
      "run.json.",
      gmapping_spa::apps::Run);
}
