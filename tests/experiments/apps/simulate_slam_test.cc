// SPDX-License-Identifier: BSD-3-Clause
// SLAM on a simulated robot without a log in between.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/apps/input_file.h"
#include "experiments/metrics/connected_cells.h"
#include "frontend/map/map_server_io.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;

class SimulateSlam : public GmappingSpaTour {
 protected:
  CommandResult SimulateAndMap(const std::vector<std::string>& more) {
    std::vector<std::string> words = {SIMULATE_SLAM, "--output_dir=" + folder_.Path("out"),
                                      "--linear_update_m=0.5", "--seed=7"};
    for (const std::string& flag : TourFlags()) words.push_back(flag);
    words.insert(words.end(), more.begin(), more.end());
    return RunCommand(words);
  }
};

TEST_F(SimulateSlam, GivesTheBytesThatTheLogGives) {
  Run(folder_.Path("from_log"), {"--seed=7"});
  const CommandResult result = SimulateAndMap({});
  ASSERT_EQ(result.status, 0) << result.err;
  for (const std::string& name : kByteIdentical) {
    EXPECT_TRUE(Contents(folder_.Path("from_log/" + name)) == Contents(folder_.Path("out/" + name)))
        << name;
  }
  for (const std::string name : {"truth.tum", "truth.pgm", "truth.yaml"}) {
    EXPECT_TRUE(Contents(shared_->Path(name)) == Contents(folder_.Path("out/" + name))) << name;
  }
  EXPECT_EQ(ReadRunRecord(folder_.Path("from_log"))["counts"],
            ReadRunRecord(folder_.Path("out"))["counts"]);
}

TEST_F(SimulateSlam, RecordTellsWhatWasSimulated) {
  const CommandResult result =
      SimulateAndMap({"--obstacles=" WORLDS_FOLDER "/paper_obstacles.yaml", "--interference=2"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json record = ReadRunRecord(folder_.Path("out"));
  EXPECT_EQ(record["input"].size(), 3u);
  EXPECT_EQ(record["input"]["world"]["sha256"],
            IdentifyFile(WORLDS_FOLDER "/paper_building.yaml").sha256);
  EXPECT_EQ(record["input"]["path"]["sha256"], IdentifyFile(shared_->Path("path.yaml")).sha256);
  EXPECT_EQ(record["input"]["obstacles"]["sha256"],
            IdentifyFile(WORLDS_FOLDER "/paper_obstacles.yaml").sha256);
  EXPECT_EQ(record["flags"]["interference"], 2.0);
  EXPECT_EQ(record["flags"]["seed"], 7);
  EXPECT_FALSE(record["flags"].contains("world"));
}

TEST_F(SimulateSlam, WritesTheTruthOfObstaclesWhenThereAreSome) {
  ASSERT_EQ(SimulateAndMap({}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("out/truth_obstacles.yaml")));
  ASSERT_EQ(SimulateAndMap({"--obstacles=" WORLDS_FOLDER "/paper_obstacles.yaml"}).status, 0);
  const map::TrinaryMap obstacles = map::ReadMap(folder_.Path("out/truth_obstacles.yaml"));
  const map::TrinaryMap truth = map::ReadMap(folder_.Path("out/truth.yaml"));
  ASSERT_EQ(obstacles.cells.size(), truth.cells.size());
  EXPECT_EQ(obstacles.at(230, 320), map::CellState::kOccupied);  // the western side of the left one
  EXPECT_EQ(truth.at(230, 320), map::CellState::kOccupied);
  EXPECT_EQ(metrics::ConnectedCells(obstacles).size(), 3U);
}

TEST_F(SimulateSlam, LeavesNothingWhenItFails) {
  for (const std::string flag : {"--world=/none.yaml", "--particles=0", "--scan_rate=nan"}) {
    const CommandResult result = SimulateAndMap({flag});
    EXPECT_EQ(result.status, 1) << flag;
    EXPECT_THAT(result.err, HasSubstr("error: "));
    EXPECT_TRUE(FilesIn(folder_.Path("out")).empty()) << flag;
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
