// SPDX-License-Identifier: BSD-3-Clause
// Writes a sensor log in another format.
#include <gflags/gflags.h>
#include <glog/logging.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "experiments/apps/app.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/apps/health_record.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/log_flags.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/progress_bar.h"
#include "experiments/conversion/bag_sink.h"
#include "experiments/conversion/carmen_sink.h"
#include "experiments/conversion/db3_writer.h"
#include "experiments/conversion/mcap_writer.h"
#include "experiments/conversion/ros1_bag_writer.h"
#include "frontend/rosbag/bag_reader.h"
#include "frontend/rosbag/open_source.h"
#include "frontend/sensor/carmen_reader.h"
#include "frontend/sensor/laser_mounting.h"
#include "frontend/sensor/log_pipeline.h"

DEFINE_string(
    log, "", "Sensor log: a ROS 1 or ROS 2 bag (file or folder), or a CARMEN log, gzipped or not.");
DEFINE_string(
    output, "",
    "File to write: NAME.bag (ROS 1), NAME.mcap or NAME.db3 (ROS 2), or NAME.clf (CARMEN).");
DEFINE_bool(compress, true, "Pack the chunks of NAME.bag by bz2, those of NAME.mcap by zstd.");

namespace gmapping_spa::apps {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<sensor::RecordReader> OpenRecords(const sensor::LogOptions& options) {
  if (rosbag::IsBag(FLAGS_log)) {
    return std::make_unique<rosbag::BagReader>(rosbag::OpenSource(FLAGS_log), FLAGS_log, options,
                                               std::make_shared<rosbag::BagReport>());
  }
  return std::make_unique<sensor::LaserMountingReader>(
      std::make_unique<sensor::CarmenReader>(OpenInput(FLAGS_log), FLAGS_log, options));
}

// Nothing is taken for no return or left out that is not so by the log itself.
sensor::LogOptions ReadingOptions() {
  sensor::LogOptions options = LogOptionsFromFlags();
  const auto is_default = [](const char* flag) {
    return gflags::GetCommandLineFlagInfoOrDie(flag).is_default;
  };
  constexpr double kNoLimit_m = 1e6;
  if (is_default("usable_range_m")) options.usable_range_m = kNoLimit_m;
  if (is_default("range_min_m")) options.range_min_m = 0.0;
  sensor::CheckOptions(options);
  return options;
}

std::unique_ptr<conversion::RecordSink> MakeSink(const std::string& extension,
                                                 const std::string& path, std::ostream& out) {
  using conversion::BagSink;
  if (extension == ".bag") {
    return std::make_unique<BagSink>(
        std::make_unique<conversion::Ros1BagWriter>(out, FLAGS_compress));
  }
  if (extension == ".mcap") {
    return std::make_unique<BagSink>(std::make_unique<conversion::McapWriter>(out, FLAGS_compress));
  }
  if (extension == ".db3") return std::make_unique<BagSink>(conversion::MakeDb3Writer(path));
  if (extension == ".clf" || extension == ".log") {
    return std::make_unique<conversion::CarmenSink>(out);
  }
  FailFlag("output", FLAGS_output, "expected a name that ends in .bag, .mcap, .db3 or .clf");
}

void Run() {
  if (FLAGS_log.empty()) throw std::runtime_error("--log=FILE is missing");
  const fs::path output = FLAGS_output;
  if (!output.has_filename()) throw std::runtime_error("--output=FILE is missing");
  const std::unique_ptr<sensor::RecordReader> reader = OpenRecords(ReadingOptions());
  OutputFiles files(output.has_parent_path() ? output.parent_path().string() : ".");
  const std::string path = files.TemporaryPath(output.filename().string());
  const bool is_database = output.extension() == ".db3";
  std::ofstream out;
  if (!is_database) out.open(path, std::ios::binary | std::ios::trunc);
  const std::unique_ptr<conversion::RecordSink> sink =
      MakeSink(output.extension().string(), path, out);
  std::int64_t scans = 0, with_odometry = 0, odometry = 0;
  ProgressBar progress("records", 0);
  while (std::optional<sensor::LogRecord> record = reader->Next()) {
    ThrowIfInterrupted();
    if (const auto* scan = std::get_if<sensor::ScanRecord>(&*record)) {
      ++scans;
      with_odometry += scan->has_odometry ? 1 : 0;
      sink->OnScan(*scan);
    } else {
      ++odometry;
      sink->OnOdometry(std::get<sensor::OdometryRecord>(*record));
    }
    progress.Update(scans + odometry);
  }
  sink->Finish();
  if (!is_database && !out.flush()) throw std::runtime_error(FLAGS_output + ": cannot be written");
  out.close();
  files.Commit();
  WarnOf(reader->counts());
  for (const auto& [loss, count] : sink->losses()) {
    if (count > 0) LOG(WARNING) << count << ' ' << loss;
  }
  std::cout << scans << " scans, " << with_odometry << " of them with odometry, and " << odometry
            << " odometry records of " << FLAGS_log << " are in " << FLAGS_output << '\n';
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {{"output", "Input and output", {"log", "output", "compress"}}};
  return Join({output, LogFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "writes a sensor log in another format, by the ending of the output's name.\n"
      "Usage: convert_log --log=FILE --output=NAME.bag|NAME.mcap|NAME.db3|NAME.clf\n"
      "Scans, odometry and the mounting of the laser are kept. Unless said otherwise, "
      "--usable_range_m and --range_min_m limit nothing here.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
