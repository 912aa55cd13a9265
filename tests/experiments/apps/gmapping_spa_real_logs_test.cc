// SPDX-License-Identifier: BSD-3-Clause
// gmapping_spa with its default flags on logs of real buildings. A minute each: label "long".
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <string>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/json.h"
#include "experiments/metrics/relations.h"
#include "tests/real_data.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

class DefaultFlagsOnRealLogs : public ::testing::Test {
 protected:
  void Run(const std::string& log) {
    const CommandResult result = RunCommand({GMAPPING_SPA, "--threads=2", "--seed=1",
                                             "--log=" + log, "--output_dir=" + folder_.path()});
    ASSERT_EQ(result.status, 0) << result.err;
  }

  // Skips the test where there is no log.
  void ExpectRelationError(const std::string& name, double bound_m) {
    const auto log = RealDataPath("carmen/" + name + ".clf.gz");
    const auto relations_path = RealDataPath("relations/" + name + ".relations.gz");
    if (!log || !relations_path) GTEST_SKIP() << "no real data";
    ASSERT_NO_FATAL_FAILURE(Run(*log));
    const std::string path = folder_.Path("trajectory.tum");
    const metrics::RelationsSummary summary = metrics::EvaluateRelations(
        metrics::ReadRelations(*OpenInput(*relations_path), *relations_path),
        backend::ReadTum(*OpenInput(path), path), {});
    std::cout << name << ": " << summary.translation_m.mean << " m, " << summary.rotation_deg.mean
              << " deg\n";
    EXPECT_EQ(summary.not_associated, 0);
    EXPECT_LE(summary.translation_m.mean, bound_m);
  }

  // On the first lines of a log, on which the robot comes nowhere twice: any closure is wrong.
  void ExpectNoClosures(const std::string& name, int lines) {
    const auto log = RealDataPath("carmen/" + name + ".clf.gz");
    if (!log) GTEST_SKIP() << "no real data";
    const auto in = OpenInput(*log);
    std::ofstream out(folder_.Path("piece.clf"));
    std::string line;
    for (int k = 0; k < lines && std::getline(*in, line); ++k) out << line << '\n';
    out.close();
    ASSERT_NO_FATAL_FAILURE(Run(folder_.Path("piece.clf")));
    const Json record = Json::parse(std::ifstream(folder_.Path("run.json")));
    EXPECT_GT(record["counts"]["updates"], 20);
    EXPECT_EQ(record["loop_closures"]["accepted"], 0) << record["loop_closures"];
  }

  TemporaryFolder folder_;
};

// The bounds are 4 % above what three seeds give, which differ by 2 % at most.
TEST_F(DefaultFlagsOnRealLogs, IntelIsPrecise) { ExpectRelationError("intel", 0.0136); }

TEST_F(DefaultFlagsOnRealLogs, Fr079IsPrecise) { ExpectRelationError("fr079", 0.0335); }

TEST_F(DefaultFlagsOnRealLogs, AcesIsPrecise) { ExpectRelationError("aces", 0.0363); }

// 150 s.
TEST_F(DefaultFlagsOnRealLogs, AcesBeginsWithoutAClosure) { ExpectNoClosures("aces", 1800); }

// 440 s and 120 m: soon after that the odometry comes back to within 10 m of where it was.
TEST_F(DefaultFlagsOnRealLogs, MitKillianBeginsWithoutAClosure) {
  ExpectNoClosures("mit-killian", 1000);
}

}  // namespace
}  // namespace gmapping_spa::apps
