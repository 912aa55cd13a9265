// SPDX-License-Identifier: BSD-3-Clause
// What gmapping_spa writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "backend/graph/g2o_io.h"
#include "backend/graph/kitti_io.h"
#include "backend/graph/stamps_io.h"
#include "experiments/apps/input_file.h"
#include "frontend/map/map_server_io.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST_F(GmappingSpaTour, WritesAllFilesAndNoOthers) {
  std::vector<std::string> files = kByteIdentical;
  files.push_back("run.json");
  EXPECT_THAT(FilesIn(Result()), ::testing::UnorderedElementsAreArray(files));
}

TEST_F(GmappingSpaTour, TrajectoryHasTheScansOfTheInputInTheirOrder) {
  const backend::Trajectory truth = ReadTrajectory(shared_->Path("truth.tum"));
  const backend::Trajectory trajectory = ReadTrajectory(Result("trajectory.tum"));
  ASSERT_GT(truth.size(), 50u);
  ASSERT_THAT(trajectory, SizeIs(truth.size()));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(trajectory[i].stamp_s, truth[i].stamp_s, 1e-5);
  }
}

TEST_F(GmappingSpaTour, KittiHasThePosesAndTimesOfTum) {
  const backend::Trajectory tum = ReadTrajectory(Result("trajectory.tum"));
  std::istringstream kitti(Contents(Result("trajectory.kitti")));
  const std::vector<backend::SE2> poses = backend::ReadKitti(kitti, "trajectory.kitti");
  std::istringstream times(Contents(Result("times.txt")));
  ASSERT_THAT(poses, SizeIs(tum.size()));
  for (std::size_t k = 0; k < tum.size(); ++k) {
    EXPECT_EQ(poses[k].translation(), tum[k].world_T_robot.translation());
    EXPECT_NEAR(poses[k].theta, tum[k].world_T_robot.theta, 1e-15);
    double stamp_s = -1.0;
    times >> stamp_s;
    EXPECT_EQ(stamp_s, tum[k].stamp_s);
  }
}

TEST_F(GmappingSpaTour, NodesOfTheGraphHaveStampsOfScans) {
  std::istringstream in(Contents(Result("graph.g2o")));
  std::istringstream stamps(Contents(Result("graph.stamps")));
  backend::PoseGraph graph = backend::ReadG2o(in, "graph.g2o");
  backend::ReadStamps(stamps, "graph.stamps", &graph);
  const backend::Trajectory trajectory = ReadTrajectory(Result("trajectory.tum"));
  for (const backend::Node& node : graph.nodes) {
    const auto scan = std::ranges::find(trajectory, node.stamp_s, &backend::StampedPose::stamp_s);
    ASSERT_NE(scan, trajectory.end()) << node.id;
    EXPECT_NEAR(scan->world_T_robot.x, node.world_T_node.x, 0.3) << node.id;
  }
}

TEST_F(GmappingSpaTour, MapCellsAreThoseOfTheMap) {
  const std::string yaml = Contents(Result("map.yaml"));
  const std::string path = folder_.FileWith(
      "map.yaml", "image: " + Result("map_cells.png") + yaml.substr(yaml.find('\n')));
  const map::TrinaryMap expected = map::ReadMap(Result("map.yaml"));
  EXPECT_EQ(map::ReadMap(path).cells, expected.cells);
  std::istringstream world_file(Contents(Result("map_cells.pngw")));
  double resolution_m = 0.0;
  world_file >> resolution_m;
  EXPECT_EQ(resolution_m, expected.resolution_m);
}

TEST_F(GmappingSpaTour, TrajectoryKeepsTheOrderOfAnInputThatIsNotInOrderOfTime) {
  std::istringstream log(Contents(Log()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with("ROBOTLASER1 ")) lines.push_back(line);
  }
  ASSERT_GT(lines.size(), 20u);
  std::swap(lines[10], lines[12]);
  std::string disordered;
  for (const std::string& line : lines) disordered += line + '\n';
  const std::string output_dir = folder_.Path("out");
  const auto result =
      RunCommand(Command(output_dir, {"--log=" + folder_.FileWith("disordered.clf", disordered)}));
  ASSERT_EQ(result.status, 0) << result.err;
  const backend::Trajectory expected = ReadTrajectory(Result("trajectory.tum"));
  const backend::Trajectory found = ReadTrajectory(output_dir + "/trajectory.tum");
  ASSERT_THAT(found, SizeIs(lines.size()));
  EXPECT_EQ(found[10].stamp_s, expected[12].stamp_s);
  EXPECT_EQ(found[12].stamp_s, expected[10].stamp_s);
  EXPECT_EQ(found[10].world_T_robot, expected[12].world_T_robot);
}

TEST_F(GmappingSpaTour, MapHasFreeAndOccupiedCells) {
  const map::TrinaryMap map = map::ReadMap(Result("map.yaml"));
  const auto count = [&](map::CellState state) {
    return std::count(map.cells.begin(), map.cells.end(), state);
  };
  // The tour is 10 m long in a corridor more than 2 m wide; cells are 0.05 m wide.
  EXPECT_GT(count(map::CellState::kFree), 10 * 2 * 400);
  EXPECT_GT(count(map::CellState::kOccupied), 2 * 10 * 20);
  EXPECT_GT(count(map::CellState::kUnknown), 0);
}

TEST_F(GmappingSpaTour, PictureIsAPngOfTheMap) {
  const std::string png = Contents(Result("map.png"));
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_GT(png.size(), 2000u);
}

TEST_F(GmappingSpaTour, GraphHasANodePerUpdateAndEdgesBetweenNeighborsAndForClosures) {
  std::ifstream in(Result("graph.g2o"));
  const backend::PoseGraph graph = backend::ReadG2o(in, "graph.g2o");
  const Json record = ReadRunRecord(Result());
  const std::size_t updates = record["counts"]["updates"];
  const std::size_t closures = record["loop_closures"]["accepted"];
  ASSERT_GT(updates, 20u);
  EXPECT_THAT(graph.nodes, SizeIs(updates));
  EXPECT_GE(closures, 2u);
  EXPECT_THAT(graph.edges, SizeIs(updates - 1 + closures));
}

TEST_F(GmappingSpaTour, ClosuresAreATableOfAllCandidates) {
  std::istringstream table(Contents(Result("loop_closures.csv")));
  std::string line;
  std::getline(table, line);
  EXPECT_THAT(line, StartsWith("old_node,node,old_stamp_s,stamp_s,"));
  const auto columns = std::count(line.begin(), line.end(), ',');
  int candidates = 0, accepted = 0;
  while (std::getline(table, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    ++candidates;
    if (line.ends_with(",accepted")) ++accepted;
  }
  const Json counts = ReadRunRecord(Result())["loop_closures"];
  EXPECT_EQ(counts["candidates"], candidates);
  EXPECT_EQ(counts["accepted"], accepted);
}

TEST_F(GmappingSpaTour, RunRecordTellsWhatWasRunOnWhat) {
  const Json record = ReadRunRecord(Result());
  const FileIdentity log = IdentifyFile(Log());
  EXPECT_EQ(record["input"]["sha256"], log.sha256);
  EXPECT_EQ(record["input"]["bytes"], log.bytes);
  EXPECT_EQ(record["flags"]["particles"], 5);
  EXPECT_EQ(record["flags"]["linear_update_m"], 0.5);
  EXPECT_EQ(record["flags"]["backend"], "spa");
  EXPECT_EQ(RunCommand({GMAPPING_SPA, "--version"}).out,
            "gmapping_spa version " + record["versions"]["gmapping_spa"].get<std::string>() + "+" +
                record["versions"]["commit"].get<std::string>() + "\n");
  EXPECT_EQ(record["counts"]["scans"], ReadTrajectory(shared_->Path("truth.tum")).size());
  EXPECT_EQ(record["counts"]["scans"], record["input"]["records"]["scans"]);
  EXPECT_EQ(record["input"]["records"]["malformed_records"], 0);
  EXPECT_GE(record["counts"]["corrections"], 1);
  EXPECT_GE(record["graph_thread"]["started"], 2);
  EXPECT_EQ(record["graph_thread"]["taken"], record["graph_thread"]["started"]);
  EXPECT_EQ(record["graph_thread"]["failed"], 0);
  EXPECT_EQ(record["graph_thread"]["late"], 0);
  EXPECT_EQ(record["resources"]["threads"], 1);
  EXPECT_GT(record["resources"]["peak_memory_mb"], 1.0);
  EXPECT_GT(record["resources"]["processing_s"], 0.0);
}

TEST_F(GmappingSpaTour, WhatTheReaderNoticedIsSaidOnceAndRecorded) {
  EXPECT_EQ(ReadRunRecord(Result())["health"].count("unknown_records"), 0u);
  const std::string output_dir = folder_.Path("out");
  const std::string log =
      folder_.FileWith("odd.clf", "WHAT 1 2\n" + Contents(Log()) + "WHAT 3 4\n");
  const CommandResult result = RunCommand(Command(output_dir, {"--log=" + log}));
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("unknown_records: 2 records of an unknown type"));
  const Json health = ReadRunRecord(output_dir)["health"];
  EXPECT_EQ(health["unknown_records"]["count"], 2);
}

TEST_F(GmappingSpaTour, HelpShowsDefaultsAsTheyAreWritten) {
  const CommandResult help = RunCommand({GMAPPING_SPA, "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("default: 0.05\n"));
  EXPECT_THAT(help.out, Not(HasSubstr("0.0500000")));
}

}  // namespace
}  // namespace gmapping_spa::apps
