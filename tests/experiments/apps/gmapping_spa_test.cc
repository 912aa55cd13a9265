// gmapping_spa from end to end, on a short tour of the simulated building.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "backend/g2o_io.h"
#include "backend/trajectory_io.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/json.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/trajectory_error.h"
#include "frontend/map/map_server_io.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::vector<std::string> kByteIdentical = {"trajectory.tum", "map.pgm", "map.yaml", "map.png",
                                                 "graph.g2o"};

std::string Contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

backend::Trajectory ReadTrajectory(const std::string& path) {
  std::ifstream in(path);
  return backend::ReadTum(in, path);
}

Json ReadRunRecord(const std::string& folder) {
  return Json::parse(Contents(folder + "/run.json"));
}

std::vector<std::string> FilesIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code absent;  // no folder holds no files
  for (const auto& entry : std::filesystem::directory_iterator(folder, absent)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

class GmappingSpaApp : public ::testing::Test {
 protected:
  // One log for all tests of a process, and one result that none of them changes.
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TemporaryFolder>();
    const std::string path = shared_->FileWith("path.yaml",
                                               "way_points:\n  - [3, 8.2]\n  - [13, 8.2]\n"
                                               "  - [8.2, 8.2]\n  - [8.2, 12.2]\n");
    const CommandResult simulate =
        RunCommand({SIMULATE, "--world=" WORLDS_FOLDER "/paper_building.yaml", "--path=" + path,
                    "--output_dir=" + shared_->path(), "--beams=120", "--scan_rate=5",
                    "--odometry_noise=5", "--seed=7"});
    ASSERT_EQ(simulate.status, 0) << simulate.err;
    const CommandResult slam = RunCommand(Command(shared_->Path("result")));
    ASSERT_EQ(slam.status, 0) << slam.err;
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static std::string Log() { return shared_->Path("log.clf"); }
  static std::string Result(const std::string& file = "") {
    return shared_->Path("result/" + file);
  }

  static std::vector<std::string> Command(const std::string& output_dir,
                                          const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {GMAPPING_SPA, "--log=" + Log(), "--output_dir=" + output_dir,
                                      "--particles=5", "--linear_update_m=0.5"};
    words.insert(words.end(), more.begin(), more.end());  // the last one of equal flags counts
    return words;
  }

  // Everything as in the shared result, but for run.json's "resources".
  static void ExpectSameResult(const std::string& folder) {
    for (const std::string& name : kByteIdentical) {
      EXPECT_TRUE(Contents(Result(name)) == Contents(folder + "/" + name)) << name;
    }
    Json expected = ReadRunRecord(Result()), found = ReadRunRecord(folder);
    expected.erase("resources");
    found.erase("resources");
    EXPECT_EQ(expected, found);
  }

  inline static std::unique_ptr<TemporaryFolder> shared_;
  TemporaryFolder folder_;
};

TEST_F(GmappingSpaApp, WritesAllFilesAndNoOthers) {
  EXPECT_THAT(FilesIn(Result()),
              ::testing::UnorderedElementsAre("trajectory.tum", "map.pgm", "map.yaml", "map.png",
                                              "graph.g2o", "run.json"));
}

TEST_F(GmappingSpaApp, TrajectoryHasTheScansOfTheInputInTheirOrder) {
  const backend::Trajectory truth = ReadTrajectory(shared_->Path("truth.tum"));
  const backend::Trajectory trajectory = ReadTrajectory(Result("trajectory.tum"));
  ASSERT_GT(truth.size(), 50u);
  ASSERT_THAT(trajectory, SizeIs(truth.size()));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(trajectory[i].stamp_s, truth[i].stamp_s, 1e-5);
  }
}

TEST_F(GmappingSpaApp, TrajectoryKeepsTheOrderOfAnInputThatIsNotInOrderOfTime) {
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

TEST_F(GmappingSpaApp, MapHasFreeAndOccupiedCells) {
  const map::TrinaryMap map = map::ReadMap(Result("map.yaml"));
  const auto count = [&](map::CellState state) {
    return std::count(map.cells.begin(), map.cells.end(), state);
  };
  // The tour is 10 m long in a corridor more than 2 m wide; cells are 0.05 m wide.
  EXPECT_GT(count(map::CellState::kFree), 10 * 2 * 400);
  EXPECT_GT(count(map::CellState::kOccupied), 2 * 10 * 20);
  EXPECT_GT(count(map::CellState::kUnknown), 0);
}

TEST_F(GmappingSpaApp, PictureIsAPngOfTheMap) {
  const std::string png = Contents(Result("map.png"));
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_GT(png.size(), 2000u);
}

TEST_F(GmappingSpaApp, GraphHasANodePerUpdateAndAnEdgeBetweenNeighbours) {
  std::ifstream in(Result("graph.g2o"));
  const backend::PoseGraph graph = backend::ReadG2o(in, "graph.g2o");
  const std::size_t updates = ReadRunRecord(Result())["counts"]["updates"];
  ASSERT_GT(updates, 20u);
  EXPECT_THAT(graph.nodes, SizeIs(updates));
  EXPECT_THAT(graph.edges, SizeIs(updates - 1));
}

TEST_F(GmappingSpaApp, RunRecordTellsWhatWasRunOnWhat) {
  const Json record = ReadRunRecord(Result());
  const FileIdentity log = IdentifyFile(Log());
  EXPECT_EQ(record["input"]["sha256"], log.sha256);
  EXPECT_EQ(record["input"]["bytes"], log.bytes);
  EXPECT_EQ(record["flags"]["particles"], 5);
  EXPECT_EQ(record["flags"]["linear_update_m"], 0.5);
  EXPECT_EQ(record["flags"]["backend"], "none");
  EXPECT_NE(record["versions"]["gmapping_spa"], "");
  EXPECT_EQ(record["counts"]["scans"], ReadTrajectory(shared_->Path("truth.tum")).size());
  EXPECT_EQ(record["counts"]["scans"], record["input"]["records"]["scans"]);
  EXPECT_EQ(record["input"]["records"]["malformed_records"], 0);
  EXPECT_EQ(record["resources"]["threads"], 1);
  EXPECT_GT(record["resources"]["peak_memory_mb"], 1.0);
  EXPECT_GT(record["resources"]["processing_s"], 0.0);
}

TEST_F(GmappingSpaApp, HelpShowsDefaultsAsTheyAreWritten) {
  const CommandResult help = RunCommand({GMAPPING_SPA, "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, ::testing::HasSubstr("default: 0.05\n"));
  EXPECT_THAT(help.out, ::testing::Not(::testing::HasSubstr("0.0500000")));
}

TEST_F(GmappingSpaApp, SecondRunGivesTheSameBytes) {
  ASSERT_EQ(RunCommand(Command(folder_.path())).status, 0);
  ExpectSameResult(folder_.path());
}

TEST_F(GmappingSpaApp, ThreadsDoNotChangeTheResult) {
  ASSERT_EQ(RunCommand(Command(folder_.path(), {"--threads=2"})).status, 0);
  ExpectSameResult(folder_.path());
  EXPECT_EQ(ReadRunRecord(folder_.path())["resources"]["threads"], 2);
}

TEST_F(GmappingSpaApp, AnotherSeedGivesAnotherTrajectory) {
  ASSERT_EQ(RunCommand(Command(folder_.path(), {"--seed=2"})).status, 0);
  EXPECT_FALSE(Contents(Result("trajectory.tum")) == Contents(folder_.Path("trajectory.tum")));
}

TEST_F(GmappingSpaApp, GzippedLogGivesTheSameResult) {
  ASSERT_EQ(RunCommand({"cp", Log(), folder_.Path("log.clf")}).status, 0);
  ASSERT_EQ(RunCommand({"gzip", "-n", folder_.Path("log.clf")}).status, 0);
  const std::string output_dir = folder_.Path("out");
  const auto result = RunCommand(Command(output_dir, {"--log=" + folder_.Path("log.clf.gz")}));
  ASSERT_EQ(result.status, 0) << result.err;
  for (const std::string& name : kByteIdentical) {
    EXPECT_TRUE(Contents(Result(name)) == Contents(output_dir + "/" + name)) << name;
  }
  Json plain = ReadRunRecord(Result()), gzipped = ReadRunRecord(output_dir);
  EXPECT_NE(plain["input"]["sha256"], gzipped["input"]["sha256"]);
  EXPECT_GT(plain["input"]["bytes"], gzipped["input"]["bytes"]);
  for (Json* record : {&plain, &gzipped}) {
    record->erase("resources");
    (*record)["input"].erase("sha256");
    (*record)["input"].erase("bytes");
  }
  EXPECT_EQ(plain, gzipped);
}

TEST_F(GmappingSpaApp, TrajectoryIsFarNearerToTheTruthThanDeadReckoning) {
  const backend::Trajectory truth = ReadTrajectory(shared_->Path("truth.tum"));
  const auto error_m = [&](const std::string& path) {
    return metrics::AbsoluteTrajectoryError(
               metrics::AssociateByStamp(truth, ReadTrajectory(path), 0.01),
               metrics::Alignment::kSe2)
        .translation_m.rmse;
  };
  // Without updates after the first scan, all poses come from the odometry.
  const std::vector<std::string> dead_reckoning = {"--linear_update_m=1000",
                                                   "--angular_update_rad=1000"};
  ASSERT_EQ(RunCommand(Command(folder_.path(), dead_reckoning)).status, 0);
  constexpr double kBoundM = 0.05;
  EXPECT_LT(error_m(Result("trajectory.tum")), kBoundM);
  EXPECT_GT(error_m(folder_.Path("trajectory.tum")), 3.0 * kBoundM);
}

// Starts the program on work for minutes, waits until it has made its output folder, so that it is
// past its start, and sends the signal. Returns the exit status.
int StatusAfterSignal(std::vector<std::string> command, const std::string& output_dir, int signal) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  while (!std::filesystem::exists(output_dir) && waitpid(child, nullptr, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // into the middle of the log
  kill(child, signal);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST_F(GmappingSpaApp, InterruptedRunLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string output_dir = folder_.Path("out");
    EXPECT_EQ(StatusAfterSignal(Command(output_dir, {"--particles=1000", "--linear_update_m=0.05"}),
                                output_dir, signal),
              130);
    EXPECT_FALSE(std::filesystem::exists(output_dir));
  }
}

TEST_F(GmappingSpaApp, LogThatBreaksOffLeavesNothingBehind) {
  ASSERT_EQ(RunCommand({"cp", Log(), folder_.Path("log.clf")}).status, 0);
  ASSERT_EQ(RunCommand({"gzip", "-n", folder_.Path("log.clf")}).status, 0);
  const std::string truncated = folder_.Path("log.clf.gz");
  std::filesystem::resize_file(truncated, std::filesystem::file_size(truncated) - 20);
  const std::string output_dir = folder_.Path("out");
  const auto result = RunCommand(Command(output_dir, {"--log=" + truncated}));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "gmapping_spa: error: " + truncated + ": truncated or corrupt gzip file\n");
  EXPECT_FALSE(std::filesystem::exists(output_dir));
}

TEST_F(GmappingSpaApp, FailedRunKeepsAnEarlierResult) {
  const std::string output_dir = folder_.Path("out");
  std::filesystem::copy(Result(), output_dir);
  const std::string broken = folder_.FileWith("log.clf", Contents(Log()) + "FLASER -1\n");
  EXPECT_EQ(RunCommand(Command(output_dir, {"--log=" + broken, "--bad_record=fail"})).status, 1);
  EXPECT_THAT(FilesIn(output_dir), SizeIs(kByteIdentical.size() + 1));
  ExpectSameResult(output_dir);
  EXPECT_EQ(Contents(output_dir + "/run.json"), Contents(Result("run.json")));
}

}  // namespace
}  // namespace gmapping_spa::apps
