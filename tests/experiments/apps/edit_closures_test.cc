// SPDX-License-Identifier: BSD-3-Clause
// The command line of edit_closures, on the session of a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "backend/graph/g2o_io.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> CellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

class EditClosuresTour : public GmappingSpaTour {
 protected:
  static void SetUpTestSuite() {
    // Long enough for closures to be found on the way, not in the end alone.
    MakeTour("[3, 8.2], [13, 8.2], [8.2, 8.2], [8.2, 12.2], [8.2, 8.2], [3, 8.2]");
    MustSucceed(Command(shared_->Path("saved"), {"--save_session=" + Session()}));
  }

  static std::string Session() { return shared_->Path("tour.session"); }
  static std::string Table() { return Contents(shared_->Path("saved/loop_closures.csv")); }

  // The table, with another verdict of the rows whose verdict is `from`.
  static std::string TableWith(const std::string& from, const std::string& to) {
    std::string table;
    for (const std::string& line : LinesOf(Table())) {
      const std::size_t word = line.rfind(',') + 1;
      table += line.substr(0, word) + (line.substr(word) == from ? to : line.substr(word)) + '\n';
    }
    return table;
  }

  // A line of the table with the verdict.
  static std::string RowOf(const std::string& verdict) {
    for (const std::string& line : LinesOf(Table())) {
      if (line.ends_with("," + verdict)) return line;
    }
    ADD_FAILURE() << "no row of the verdict " << verdict;
    return "";
  }

  CommandResult Edit(const std::string& table, std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(),
                 {EDIT_CLOSURES, "--session=" + Session(),
                  "--closures=" + folder_.FileWith("edited.csv", table), "--output_dir=" + out_});
    return RunCommand(flags);
  }

  void ExpectRefused(const CommandResult& result, const std::string& why) const {
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, HasSubstr(why));
    EXPECT_FALSE(std::filesystem::exists(out_));
  }

  Json Edits() const { return ReadRunRecord(out_)["edits"]; }

  const std::string out_ = folder_.Path("out");
};

TEST_F(EditClosuresTour, WithoutChangesTheResultIsThatOfTheRun) {
  const CommandResult result = Edit(Table(), {"--refine_scans"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(FilesIn(out_), ::testing::UnorderedElementsAreArray(FilesIn(Result())));
  EXPECT_EQ(Contents(out_ + "/loop_closures.csv"), Table());
  const backend::Trajectory expected = ReadTrajectory(Result("trajectory.tum"));
  const backend::Trajectory found = ReadTrajectory(out_ + "/trajectory.tum");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const backend::SE2 off = Between(expected[k].world_T_robot, found[k].world_T_robot);
    EXPECT_LT(off.translation().norm(), 0.002) << k;
  }
  const Json edits = Edits();
  EXPECT_EQ(edits["unchanged"], edits["rows"]);
  EXPECT_EQ(edits["taken_out"], 0);
  EXPECT_EQ(ReadRunRecord(out_)["flags"]["linear_update_m"], 0.5) << "of the session";
}

TEST_F(EditClosuresTour, RejectedClosuresAreOutOfTheGraphAndStayRejected) {
  const std::string session = folder_.Path("edited.session");
  const CommandResult result =
      Edit(TableWith("accepted", "rejected"), {"--save_session=" + session});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_GE(Edits()["rejected"], 1);
  const Json closures = ReadRunRecord(out_)["loop_closures"];
  EXPECT_EQ(closures["accepted"], 0);
  EXPECT_EQ(closures["rejected"]["rejected"], Edits()["rejected"]);

  // The final optimization looks everywhere again.
  const std::string resumed = folder_.Path("resumed");
  Run(resumed, {"--resume=" + session});
  for (const std::string& line : LinesOf(Table())) {
    if (!line.ends_with(",accepted")) continue;
    const std::vector<std::string> cells = CellsOf(line);
    for (const std::string& found : LinesOf(Contents(resumed + "/loop_closures.csv"))) {
      if (!found.ends_with(",accepted")) continue;
      const std::vector<std::string> other = CellsOf(found);
      EXPECT_FALSE(cells[0] == other[0] && cells[1] == other[1]) << found;
    }
  }
}

TEST_F(EditClosuresTour, AnAddedClosureIsMeasuredByTheScans) {
  const std::string row = RowOf("accepted");
  const std::vector<std::string> cells = CellsOf(row);
  std::string table = Table();
  table.erase(table.find(row), row.size() + 1);
  table += cells[0] + "," + cells[1] + std::string(cells.size() - 2, ',') + "add\n";
  const CommandResult result = Edit(table);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(Edits()["added"], 1);
  EXPECT_EQ(Edits()["measured"], 1);
  for (const std::string& line : LinesOf(Contents(out_ + "/loop_closures.csv"))) {
    const std::vector<std::string> found = CellsOf(line);
    if (found[0] != cells[0] || found[1] != cells[1] || !line.ends_with(",hand,,accepted"))
      continue;
    for (const int column : {12, 13, 14}) {  // x_m, y_m, theta_rad
      EXPECT_NEAR(std::stod(found[column]), std::stod(cells[column]), 0.02);
    }
    return;
  }
  ADD_FAILURE() << "expected a row of the closure that was added";
}

// A measurement that is off by a meter bends the map: somebody's word is final.
TEST_F(EditClosuresTour, AnAddedPoseCountsWhateverTheScansSay) {
  const std::vector<std::string> cells = CellsOf(RowOf("accepted"));
  const CommandResult result = Edit("old_node,node,x_m,y_m,theta_rad,verdict\n" + cells[0] + "," +
                                    cells[1] + "," + std::to_string(std::stod(cells[12]) + 1.0) +
                                    "," + cells[13] + "," + cells[14] + ",add\n");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("1 closures have no information (I11 ... I33)"));
  EXPECT_THAT(result.err, HasSubstr("accepted closures have no row any more"));
  EXPECT_EQ(Edits()["default_information"], 1);
  std::ifstream in(out_ + "/graph.g2o");
  const backend::PoseGraph graph = backend::ReadG2o(in, "graph.g2o");
  const backend::SE2 between = Between(graph.nodes.at(std::stoul(cells[0])).world_T_node,
                                       graph.nodes.at(std::stoul(cells[1])).world_T_node);
  EXPECT_GT(
      (between.translation() - Eigen::Vector2d(std::stod(cells[12]), std::stod(cells[13]))).norm(),
      0.3);
}

TEST_F(EditClosuresTour, WhatCannotBeDoneIsOneLineAndWritesNothing) {
  const std::string header = "old_node,node,verdict\n", edited = folder_.Path("edited.csv");
  ExpectRefused(Edit(header + "0,100000,add\n"),
                "edit_closures: error: " + edited + ":2: expected a node from 0 to ");
  ExpectRefused(Edit(header + "0,1,maybe\n"), edited + ":2: expected accepted, rejected, add");
  ExpectRefused(Edit(Table(), {"--particles=3"}),
                "--particles: expected that of the session, 5, or none, found 3");
  ExpectRefused(Edit(Table(), {"--session=" + Result("graph.g2o")}), Result("graph.g2o"));
  ExpectRefused(Edit(Table(), {"--session="}), "--session=FILE is missing");
}

TEST_F(EditClosuresTour, NodesWhoseScansDoNotFitAreRefusedWithTheReason) {
  // Another closure puts them 40 m apart, which is more than the search looks for.
  const Json record = ReadRunRecord(Result());
  const int last = record["counts"]["updates"].get<int>() - 1;
  const std::string table = "old_node,node,x_m,y_m,theta_rad,I11,I12,I13,I22,I23,I33,verdict\n0," +
                            std::to_string(last) + ",40,0,0,1e8,0,0,1e8,0,1e8,add\n0," +
                            std::to_string(last - 1) + ",,,,,,,,,,add\n";
  ExpectRefused(Edit(table),
                folder_.Path("edited.csv") + ":3: expected nodes whose scans fit, or their pose");
}

TEST_F(EditClosuresTour, TheBackEndMayBeAnother) {
  const CommandResult result = Edit(Table(), {"--backend=none"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(ReadRunRecord(out_)["flags"]["backend"], "none");
}

}  // namespace
}  // namespace gmapping_spa::apps
