// SPDX-License-Identifier: BSD-3-Clause
// Runs gmapping_spa with a flag file on whole logs of real buildings.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_REAL_LOGS_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_REAL_LOGS_H_

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/input_file.h"
#include "experiments/metrics/relations.h"
#include "tests/real_data.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa {

class RealLogs : public ::testing::Test {
 protected:
  // Writes the results for the log of `name` to folder_. `setting`: a file of experiments/flags.
  void Slam(const std::string& name, const std::string& setting,
            const std::vector<std::string>& flags) {
    std::vector<std::string> words = {GMAPPING_SPA, "--flagfile=" FLAGS_FOLDER "/" + setting,
                                      "--threads=2",
                                      "--log=" + RealDataPath("carmen/" + name + ".clf.gz").value(),
                                      "--output_dir=" + folder_.path()};
    words.insert(words.end(), flags.begin(), flags.end());
    const CommandResult result = RunCommand(words);
    ASSERT_EQ(result.status, 0) << result.err;
  }

  backend::Trajectory Trajectory() const {
    const std::string path = folder_.Path("trajectory.tum");
    return backend::ReadTum(*apps::OpenInput(path), path);
  }

  metrics::RelationsSummary Score(const std::string& name) const {
    const std::string path = RealDataPath("relations/" + name + ".relations.gz").value();
    const metrics::RelationsSummary summary = metrics::EvaluateRelations(
        metrics::ReadRelations(*apps::OpenInput(path), path), Trajectory(), {});
    std::cout << name << ": " << summary.translation_m.mean << " m, " << summary.rotation_deg.mean
              << " deg\n";
    EXPECT_EQ(summary.not_associated, 0);
    return summary;
  }

  // Mean relation errors of the seeds 1, 2, ..., `seeds`, in m.
  std::vector<double> Errors(const std::string& name, const std::string& setting, int seeds,
                             std::vector<std::string> flags) {
    std::vector<double> errors_m;
    flags.emplace_back();
    for (int seed = 1; seed <= seeds; ++seed) {
      flags.back() = "--seed=" + std::to_string(seed);
      Slam(name, setting, flags);
      if (HasFatalFailure()) return {};
      errors_m.push_back(Score(name).translation_m.mean);
    }
    return errors_m;
  }

  static bool HaveData(const std::string& name) {
    return RealDataPath("carmen/" + name + ".clf.gz").has_value();
  }

  TemporaryFolder folder_;
};

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_REAL_LOGS_H_
