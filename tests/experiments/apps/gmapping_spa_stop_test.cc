// SPDX-License-Identifier: BSD-3-Clause
// What gmapping_spa leaves behind when it is stopped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/signal_command.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::SizeIs;

TEST_F(GmappingSpaTour, InterruptedRunWritesWhatItHasAndSaysSo) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string output_dir = folder_.Path("out" + std::to_string(signal));
    EXPECT_EQ(SignalCommand(Command(output_dir, {"--particles=100", "--linear_update_m=0.05"}),
                            output_dir, signal)
                  .status,
              128 + signal);
    EXPECT_THAT(FilesIn(output_dir), SizeIs(kByteIdentical.size() + 1));
    const Json record = ReadRunRecord(output_dir);
    EXPECT_EQ(record["interrupted"]["signal"], signal);
    EXPECT_EQ(record["interrupted"]["scans"], record["counts"]["scans"]);
    std::ifstream trajectory(output_dir + "/trajectory.tum");
    const backend::Trajectory poses = backend::ReadTum(trajectory, "trajectory.tum");
    EXPECT_EQ(record["counts"]["scans"], poses.size());
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
