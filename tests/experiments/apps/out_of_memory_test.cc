// SPDX-License-Identifier: BSD-3-Clause
// Programs that get less memory than they need end with one line that says what for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class OutOfMemoryTest : public ::testing::Test {
 protected:
  static CommandResult RunWithin(int megabytes, const std::vector<std::string>& words) {
    std::vector<std::string> command = {"sh", "-c", "ulimit -c 0; ulimit -v $0; exec \"$@\"",
                                        std::to_string(megabytes * 1024)};
    command.insert(command.end(), words.begin(), words.end());
    return RunCommand(command);
  }

  // What it says when it cannot run within so many megabytes.
  std::string ErrorWithin(int megabytes, const std::vector<std::string>& words) const {
    const CommandResult result = RunWithin(megabytes, words);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(output_dir_));
    return result.err;
  }

  // With less and less memory, as long as the libraries themselves can be loaded.
  void ExpectSuccessOrOneLine(const std::vector<std::string>& words) const {
    bool failed = false;
    for (int megabytes = 200; megabytes >= 50; megabytes -= 25) {
      std::filesystem::remove_all(output_dir_);
      const CommandResult result = RunWithin(megabytes, words);
      EXPECT_THAT(result.status, AnyOf(0, 1)) << megabytes << " MB: " << result.err;
      if (result.status == 0) continue;
      failed = true;
      EXPECT_THAT(result.err, HasSubstr("out of memory")) << megabytes << " MB";
      EXPECT_FALSE(std::filesystem::exists(output_dir_)) << megabytes << " MB";
    }
    EXPECT_TRUE(failed);
  }

  // A black image, which takes no room on the disk.
  std::string LargeMap() const {
    const std::string image = folder_.FileWith("map.pgm", "P5\n8000 8000\n255\n");
    std::filesystem::resize_file(image, std::filesystem::file_size(image) + 8000 * 8000);
    return folder_.FileWith("map.yaml",
                            "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 1\n"
                            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  }

  std::string LargeGraph() const {
    std::ofstream out(folder_.Path("graph.g2o"));
    constexpr int kNodes = 30000;
    for (int k = 0; k < kNodes; ++k) {
      out << "VERTEX_SE2 " << k << ' ' << k << " 0 0\n";
      if (k > 0) out << "EDGE_SE2 " << k - 1 << ' ' << k << " 1.01 0 0 1 0 0 1 0 1\n";
    }
    return folder_.Path("graph.g2o");
  }

  // A robot that drives away through the middle of a street.
  std::string LongLog() const {
    std::ofstream out(folder_.Path("log.clf"));
    for (int scan = 0; scan < 300; ++scan) {
      out << "FLASER 180";
      for (int beam = 0; beam < 180; ++beam) out << ' ' << 5 + beam % 20;
      const std::string pose = std::to_string(0.5 * scan) + " 0 0 ";
      out << ' ' << pose << pose << scan << " host " << scan << '\n';
    }
    return folder_.Path("log.clf");
  }

  TemporaryFolder folder_;
  std::string output_dir_ = folder_.Path("out");
};

TEST_F(OutOfMemoryTest, SimulateTellsTheSizeOfTheWorld) {
  const std::string world = folder_.FileWith("world.yaml", "size: [800, 800]\nresolution: 0.05\n");
  const std::string path = folder_.FileWith("world.path.yaml", "way_points: [[1, 1], [9, 1]]\n");
  const std::vector<std::string> command = {SIMULATE, "--world=" + world,
                                            "--output_dir=" + output_dir_};
  EXPECT_EQ(ErrorWithin(200, command), "simulate: error: out of memory while reading " + world +
                                           ": a map of 16000 x 16000 cells needs 256 MB\n");
  EXPECT_EQ(ErrorWithin(400, command),
            "simulate: error: out of memory while building the world: a map of 16000 x 16000 cells "
            "needs 512 MB\n");
}

TEST_F(OutOfMemoryTest, EvaluateMapTellsTheSizeOfTheMap) {
  const std::vector<std::string> command = {EVALUATE_MAP, "--map=" + LargeMap()};
  EXPECT_THAT(ErrorWithin(100, command),
              StartsWith("evaluate_map: error: out of memory while reading "));
  EXPECT_EQ(ErrorWithin(300, command),
            "evaluate_map: error: out of memory while measuring a map of 8000 x 8000 cells\n");
}

TEST_F(OutOfMemoryTest, OptimizeGraphSucceedsOrSaysOneLine) {
  ExpectSuccessOrOneLine(
      {OPTIMIZE_GRAPH, "--input=" + LargeGraph(), "--output=" + output_dir_ + "/graph.g2o"});
}

TEST_F(OutOfMemoryTest, GmappingSpaSucceedsOrSaysOneLine) {
  ExpectSuccessOrOneLine({GMAPPING_SPA, "--log=" + LongLog(), "--output_dir=" + output_dir_,
                          "--particles=30", "--threads=2"});
}

}  // namespace
}  // namespace gmapping_spa::apps
