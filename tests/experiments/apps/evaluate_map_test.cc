// SPDX-License-Identifier: BSD-3-Clause
// The command line of evaluate_map.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "frontend/map/map_server_io.h"
#include "tests/command_error.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps::evaluate_map_test {
namespace {

using map::CellState;
using map::TrinaryMap;
using ::testing::HasSubstr;
using ::testing::Not;

// A room of 2 m x 1 m with walls of one cell, its lower left corner at (x_m, y_m).
TrinaryMap Room(double x_m, double y_m) {
  TrinaryMap map{42, 22, 0.05, x_m - 0.05, y_m - 0.05, {}};
  map.cells.assign(42 * 22, CellState::kOccupied);
  for (int row = 1; row < 21; ++row) {
    for (int column = 1; column < 41; ++column) map.at(column, row) = CellState::kFree;
  }
  return map;
}

class EvaluateMapApp : public ::testing::Test {
 protected:
  std::string MapFile(const std::string& name, const TrinaryMap& map) const {
    std::ofstream pgm(folder_.Path(name + ".pgm"), std::ios::binary);
    map::WritePgm(map, pgm);
    std::ofstream yaml(folder_.Path(name + ".yaml"));
    map::WriteMapYaml(map, name + ".pgm", yaml);
    return folder_.Path(name + ".yaml");
  }

  TemporaryFolder folder_;
  std::string truth_ = "--truth=" + MapFile("truth", Room(0.0, 0.0));
  std::string true_poses_ =
      "--truth_trajectory=" +
      folder_.FileWith("truth.tum", "0 0.5 0.5 0 0 0 0 1\n1 1.5 0.5 0 0 0 0 1\n");
  // The same room as seen from the first pose: what gmapping_spa would write.
  std::string map_ = "--map=" + MapFile("map", Room(-0.5, -0.5));
  std::string poses_ =
      "--trajectory=" + folder_.FileWith("poses.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
};

nlohmann::json JsonOf(const std::vector<std::string>& command) {
  const CommandResult result = RunCommand(command);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return nlohmann::json::parse(result.out);
}

TEST_F(EvaluateMapApp, LaysTheMapOverTheTruthByTheTrajectories) {
  for (const std::string align : {"se2", "first"}) {
    const auto json = JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_, "--align=" + align});
    EXPECT_EQ(json["align"], align);
    EXPECT_NEAR(json["alignment"]["x_m"].get<double>(), 0.5, 1e-9);
    EXPECT_NEAR(json["alignment"]["y_m"].get<double>(), 0.5, 1e-9);
    EXPECT_NEAR(json["alignment"]["theta_rad"].get<double>(), 0.0, 1e-9);
    for (const char* zero : {"missing", "extra", "outside"}) EXPECT_EQ(json[zero], 0.0) << zero;
    for (const char* one : {"precision", "recall", "iou", "known"})
      EXPECT_EQ(json[one], 1.0) << one;
    for (const char* zero : {"map_to_truth_m", "truth_to_map_m", "shift_m"}) {
      EXPECT_NEAR(json[zero]["mean"].get<double>(), 0.0, 1e-9) << zero;
      EXPECT_NEAR(json[zero]["p95"].get<double>(), 0.0, 1e-9) << zero;
    }
    EXPECT_NEAR(json["blur_m"]["mean"].get<double>(), 0.05, 1e-9);
    EXPECT_EQ(json["seen"]["free_cells"], 40 * 20);
    EXPECT_EQ(json["seen"]["surface_elements"], 2 * (40 + 20));
    EXPECT_THAT(json["convention"].get<std::string>(), HasSubstr("null"));
  }
}

TEST_F(EvaluateMapApp, SaysWhatAReaderSees) {
  const auto json = JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_});
  EXPECT_EQ(json["broken"], false);
  EXPECT_EQ(json["walls"]["in_sight"], 4);
  for (const char* zero : {"missing", "broken", "gaps", "gaps_m", "doubled", "doubled_m"})
    EXPECT_EQ(json["walls"][zero], 0.0) << zero;
  EXPECT_EQ(json["ghost_walls"]["number"], 0);
  EXPECT_EQ(json["ghost_walls"]["length_m"], 0.0);
  EXPECT_EQ(json["corners"]["in_sight"], 4);
  EXPECT_EQ(json["corners"]["found"], 4);
  EXPECT_EQ(json["corners"]["false"], 0);
  EXPECT_FALSE(json.contains("objects"));
}

TEST_F(EvaluateMapApp, JudgesWallsWhereMostOfTheMapFits) {
  // The second half of the path is wrong, and with it the alignment, but not the map.
  const std::string poses = "--trajectory=" + folder_.FileWith("half_wrong.tum",
                                                               "0 0 0 0 0 0 0 1\n"
                                                               "1 1 0.6 0 0 0 0 1\n");
  const auto json = JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, poses,
                            "--objects=" + MapFile("walls", Room(0.0, 0.0))});
  EXPECT_EQ(json["objects"][0]["complete"], 1.0);
  EXPECT_LT(json["iou"].get<double>(), 0.5);
  EXPECT_NEAR(json["best_alignment"]["x_m"].get<double>(), 0.5, 0.03);
  EXPECT_NEAR(json["best_alignment"]["y_m"].get<double>(), 0.5, 0.03);
  EXPECT_EQ(json["walls"]["missing"], 0);
  EXPECT_EQ(json["ghost_walls"]["number"], 0);
  EXPECT_EQ(json["corners"]["found"], 4);
}

TEST_F(EvaluateMapApp, ScoresObjectsByThemselves) {
  TrinaryMap truth = Room(0.0, 0.0), objects = Room(0.0, 0.0);
  std::fill(objects.cells.begin(), objects.cells.end(), CellState::kUnknown);
  for (int row = 14; row < 18; ++row) {
    for (int column = 20; column < 30; ++column) {
      truth.at(column, row) = objects.at(column, row) = CellState::kOccupied;
    }
  }
  const std::string objects_flag = "--objects=" + MapFile("objects", objects);
  const auto scores = [&](const TrinaryMap& map) {
    return JsonOf({EVALUATE_MAP, "--map=" + MapFile("drawn", map),
                   "--truth=" + MapFile("furnished", truth), true_poses_, "--align=none",
                   objects_flag})["objects"];
  };
  ASSERT_EQ(scores(truth).size(), 1);
  EXPECT_EQ(scores(truth)[0]["there"], true);
  EXPECT_EQ(scores(truth)[0]["complete"], 1.0);
  EXPECT_NEAR(scores(truth)[0]["x_m"].get<double>(), 1.2, 1e-9);
  const auto lost = scores(Room(0.0, 0.0))[0];
  EXPECT_EQ(lost["there"], false);
  EXPECT_EQ(lost["complete"], 0.0);
  EXPECT_TRUE(lost["width_m"].is_null());
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_, objects_flag}),
              HasSubstr("stand in the true map"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, objects_flag}), HasSubstr("--truth"));
}

TEST_F(EvaluateMapApp, WithoutAlignmentTheShiftIsAnErrorAndNoTrajectoryIsNeeded) {
  const auto json = JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, "--align=none"});
  EXPECT_EQ(json["alignment"]["x_m"], 0.0);
  EXPECT_GT(json["missing"].get<double>(), 0.5);
  EXPECT_LT(json["precision"].get<double>(), 0.5);
}

TEST_F(EvaluateMapApp, WithoutTruthMeasuresTheStructureOnly) {
  const auto json = JsonOf({EVALUATE_MAP, map_});
  EXPECT_EQ(json["map"]["occupied_cells"], 2 * 42 + 2 * 20);
  EXPECT_EQ(json["map"]["enclosed_areas"], 1);
  EXPECT_EQ(json["map"]["corners"], 4);
  EXPECT_FALSE(json.contains("precision"));
}

TEST_F(EvaluateMapApp, AMapWithoutWallsHasNulls) {
  TrinaryMap empty = Room(-0.5, -0.5);
  std::fill(empty.cells.begin(), empty.cells.end(), CellState::kFree);
  const auto json =
      JsonOf({EVALUATE_MAP, "--map=" + MapFile("empty", empty), truth_, true_poses_, poses_});
  EXPECT_TRUE(json["precision"].is_null());
  EXPECT_TRUE(json["blur_m"]["mean"].is_null());
  EXPECT_EQ(json["missing"], 1.0);
}

TEST_F(EvaluateMapApp, RangeAndToleranceAreFlags) {
  const auto json = JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_, "--max_range=0.3"});
  EXPECT_EQ(json["seen"]["surface_elements"], 0);
  EXPECT_TRUE(json["missing"].is_null());
  const auto strict =
      JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, "--align=none", "--tolerance=0"});
  const auto loose =
      JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, "--align=none", "--tolerance=0.6"});
  EXPECT_GT(strict["missing"].get<double>(), loose["missing"].get<double>());
}

TEST_F(EvaluateMapApp, WritesAnErrorMap) {
  const std::string png = folder_.Path("errors.png");
  JsonOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_, "--error_map=" + png});
  EXPECT_GT(std::filesystem::file_size(png), 1000);
}

TEST_F(EvaluateMapApp, BadInputIsOneLine) {
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, "--map=" + folder_.Path("no.yaml")}), HasSubstr("no.yaml"));
  const std::string rotated =
      folder_.FileWith("rotated.yaml",
                       "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 1]\nnegate: 0\n"
                       "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, "--map=" + rotated}), HasSubstr("rotated.yaml:3"));
  const std::string broken = folder_.FileWith("broken.tum", "0 0 0 0 0 0 0 1\n1 x 0 0 0 0 0 1\n");
  EXPECT_EQ(ErrorOf({EVALUATE_MAP, map_, truth_, true_poses_, "--trajectory=" + broken}),
            "evaluate_map: error: " + broken + ":2: expected a finite number, found 'x'\n");
  const std::string far = folder_.FileWith("far.tum", "0 50 0 0 0 0 0 1\n1 51 0 0 0 0 0 1\n");
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, truth_, "--truth_trajectory=" + far, poses_}),
              HasSubstr("free space of the true map"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_,
                       "--error_map=" + folder_.Path("no/such.png")}),
              HasSubstr("such.png"));
}

TEST_F(EvaluateMapApp, BadFlagsAreOneLine) {
  EXPECT_THAT(ErrorOf({EVALUATE_MAP}), HasSubstr("--map=FILE is missing"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, truth_}), HasSubstr("--truth_trajectory"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, truth_, true_poses_}), HasSubstr("--trajectory"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, poses_}), HasSubstr("--truth"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, "--error_map=x.png"}), HasSubstr("--truth"));
  EXPECT_EQ(ErrorOf({EVALUATE_MAP, map_, truth_, true_poses_, poses_, "--align=sim3"}),
            "evaluate_map: error: --align: expected one of first, none, se2, found 'sim3'\n");
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, "--max_range=-1"}), HasSubstr("--max_range"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, "--tolerance=nan"}), HasSubstr("--tolerance"));
  EXPECT_THAT(ErrorOf({EVALUATE_MAP, map_, "--max_gap_s=-1"}), HasSubstr("--max_gap_s"));
}

}  // namespace
}  // namespace gmapping_spa::apps::evaluate_map_test
