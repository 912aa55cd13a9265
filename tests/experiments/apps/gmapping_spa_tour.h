// SPDX-License-Identifier: BSD-3-Clause
// A short tour of the simulated building, and what gmapping_spa makes of it.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_GMAPPING_SPA_TOUR_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_GMAPPING_SPA_TOUR_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/json.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/trajectory_error.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {

inline const std::vector<std::string> kByteIdentical = {
    "trajectory.tum", "trajectory.kitti", "times.txt",    "map.pgm",
    "map.yaml",       "map.png",          "map.pngw",     "map_cells.png",
    "map_cells.pngw", "graph.g2o",        "graph.stamps", "loop_closures.csv"};

inline std::string Contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

inline backend::Trajectory ReadTrajectory(const std::string& path) {
  std::ifstream in(path);
  return backend::ReadTum(in, path);
}

inline Json ReadRunRecord(const std::string& folder) {
  return Json::parse(Contents(folder + "/run.json"));
}

inline std::vector<std::string> FilesIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code absent;  // no folder holds no files
  for (const auto& entry : std::filesystem::directory_iterator(folder, absent)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

// Everything the same, but for run.json's "resources".
inline void ExpectSameResult(const std::string& expected_folder, const std::string& folder) {
  for (const std::string& name : kByteIdentical) {
    EXPECT_TRUE(Contents(expected_folder + "/" + name) == Contents(folder + "/" + name)) << name;
  }
  Json expected = ReadRunRecord(expected_folder), found = ReadRunRecord(folder);
  expected.erase("resources");
  found.erase("resources");
  EXPECT_EQ(expected, found);
}

class GmappingSpaTour : public ::testing::Test {
 protected:
  // There and back again through the same corridor, so that loops can be closed.
  static void SetUpTestSuite() { MakeTour("[3, 8.2], [13, 8.2], [3, 8.2]"); }

  // One log for all tests of a process, and one result that none of them changes.
  static void MakeTour(const std::string& way_points) {
    shared_ = std::make_unique<TemporaryFolder>();
    shared_->FileWith("path.yaml", "way_points: [" + way_points + "]\n");
    std::vector<std::string> words = {SIMULATE, "--output_dir=" + shared_->path(), "--seed=7"};
    for (const std::string& flag : TourFlags()) words.push_back(flag);
    MustSucceed(words);
    MustSucceed(Command(shared_->Path("result")));
  }
  // Aborts, as a failed assertion here would have GoogleTest skip all tests, which CTest lets pass.
  static void MustSucceed(const std::vector<std::string>& words) {
    const CommandResult result = RunCommand(words);
    if (result.status == 0) return;
    std::cerr << result.err;
    std::abort();
  }
  static void TearDownTestSuite() { shared_.reset(); }

  // Flags of the simulator, but for its seed.
  static std::vector<std::string> TourFlags() {
    return {"--world=" WORLDS_FOLDER "/paper_building.yaml", "--path=" + shared_->Path("path.yaml"),
            "--angular_resolution=3", "--scan_rate=5", "--odometry_noise=5"};
  }

  static std::string Log() { return shared_->Path("log.clf"); }
  static std::string Result(const std::string& file = "") {
    return shared_->Path("result/" + file);
  }

  static std::vector<std::string> Command(const std::string& output_dir,
                                          const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {GMAPPING_SPA, "--log=" + Log(), "--output_dir=" + output_dir,
                                      "--linear_update_m=0.5"};
    words.insert(words.end(), more.begin(), more.end());  // the last one of equal flags counts
    return words;
  }

  // Writes a result with more flags to `output_dir`.
  static void Run(const std::string& output_dir, const std::vector<std::string>& more) {
    const CommandResult result = RunCommand(Command(output_dir, more));
    ASSERT_EQ(result.status, 0) << result.err;
  }

  // Absolute trajectory error of a result.
  static double ErrorM(const std::string& folder) {
    return metrics::AbsoluteTrajectoryError(
               metrics::AssociateByStamp(ReadTrajectory(shared_->Path("truth.tum")),
                                         ReadTrajectory(folder + "/trajectory.tum"), 0.01),
               metrics::Alignment::kSe2)
        .translation_m.rmse;
  }

  inline static std::unique_ptr<TemporaryFolder> shared_;
  TemporaryFolder folder_;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_GMAPPING_SPA_TOUR_H_
