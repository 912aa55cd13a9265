// SPDX-License-Identifier: BSD-3-Clause
// The command lines of evaluate_relations and evaluate_trajectory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_error.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class EvaluateApps : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string relations_ = folder_.FileWith("r.relations", "0 1 0.9 0 0 0 0 0\n1 9 0 0 0 0 0 0\n");
  std::string poses_ =
      folder_.FileWith("poses.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 1 1 0 0 0 0 1\n");
  std::string moved_poses_ =
      folder_.FileWith("moved.tum", "0 5 5 0 0 0 0 1\n1 6 5 0 0 0 0 1\n2 6 6 0 0 0 0 1\n");
};
using EvaluateRelationsApp = EvaluateApps;
using EvaluateTrajectoryApp = EvaluateApps;

TEST_F(EvaluateRelationsApp, PrintsJson) {
  const auto result =
      RunCommand({EVALUATE_RELATIONS, "--relations=" + relations_, "--trajectory=" + poses_});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["relations"], 2);
  EXPECT_EQ(json["used"], 1);
  EXPECT_EQ(json["not_associated"], 1);
  EXPECT_NEAR(json["translation_m"]["mean"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(json["rotation_deg"]["max"].get<double>(), 0.0, 1e-12);
  EXPECT_THAT(json["convention"].get<std::string>(), HasSubstr("Kuemmerle"));
}

TEST_F(EvaluateRelationsApp, TheGapDecidesWhatIsAssociated) {
  const auto result = RunCommand(
      {EVALUATE_RELATIONS, "--relations=" + relations_, "--trajectory=" + poses_, "--max_gap_s=7"});
  EXPECT_EQ(nlohmann::json::parse(result.out)["used"], 2);
}

TEST_F(EvaluateRelationsApp, BadInputIsOneLine) {
  const std::string relations = "--relations=" + relations_, poses = "--trajectory=" + poses_;
  const std::string broken = folder_.FileWith("broken.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 nan 1\n");
  EXPECT_EQ(ErrorOf({EVALUATE_RELATIONS, relations, "--trajectory=" + broken}),
            "evaluate_relations: error: " + broken + ":2: expected a finite number, found 'nan'\n");
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, "--relations=" + poses_ + "x", poses}),
              HasSubstr(poses_ + "x"));
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, "--relations=" + folder_.path(), poses}),
              StartsWith("evaluate_relations: error: "));
  const std::string empty = folder_.FileWith("empty", "");
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, "--relations=" + empty, poses}),
              HasSubstr("holds no relations"));
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, relations, "--trajectory=" + empty}),
              HasSubstr("holds no poses"));
}

TEST_F(EvaluateRelationsApp, BadFlagsAreOneLine) {
  const std::string relations = "--relations=" + relations_, poses = "--trajectory=" + poses_;
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, poses}), HasSubstr("--relations"));
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, relations}), HasSubstr("--trajectory"));
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, relations, poses, "--max_gap_s=-1"}),
              HasSubstr("--max_gap_s"));
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, relations, poses, "--max_gap=1"}),
              HasSubstr("evaluate_relations: error: unknown flag '--max_gap'"));
  EXPECT_THAT(ErrorOf({EVALUATE_RELATIONS, relations, poses, "more"}), HasSubstr("'more'"));
}

TEST_F(EvaluateRelationsApp, AFullDeviceIsAnError) {
  const auto result = RunCommand(
      {EVALUATE_RELATIONS, "--relations=" + relations_, "--trajectory=" + poses_}, "/dev/full");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "evaluate_relations: error: cannot write to the standard output\n");
}

TEST_F(EvaluateTrajectoryApp, PrintsJson) {
  const auto result =
      RunCommand({EVALUATE_TRAJECTORY, "--truth=" + poses_, "--trajectory=" + moved_poses_});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["associated"], 3);
  EXPECT_EQ(json["ate"]["pairs"], 3);
  EXPECT_EQ(json["rpe"]["pairs"], 2);
  EXPECT_NEAR(json["ate"]["translation_m"]["rmse"].get<double>(), 0.0, 1e-12);
  EXPECT_NEAR(json["alignment"]["x_m"].get<double>(), -5.0, 1e-12);
  EXPECT_THAT(json["convention"].get<std::string>(), HasSubstr("evo"));
}

TEST_F(EvaluateTrajectoryApp, AlignmentAndStepAreChosenByFlags) {
  const auto result =
      RunCommand({EVALUATE_TRAJECTORY, "--truth=" + poses_, "--trajectory=" + moved_poses_,
                  "--align=none", "--rpe_unit=s", "--rpe_delta=2"});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_NEAR(json["ate"]["translation_m"]["rmse"].get<double>(), std::sqrt(50.0), 1e-12);
  EXPECT_EQ(json["rpe"]["pairs"], 1);
}

TEST_F(EvaluateTrajectoryApp, KittiGivesTheErrorsOfTum) {
  const std::string kitti = folder_.FileWith(
      "kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 1 0 0 1 0\n");
  const std::string off = folder_.FileWith(
      "off.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 2 0 0 1 0\n");
  const std::string off_tum =
      folder_.FileWith("off.tum", "0 0 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n2 1 2 0 0 0 0 1\n");
  const auto expected = nlohmann::json::parse(
      RunCommand({EVALUATE_TRAJECTORY, "--truth=" + poses_, "--trajectory=" + off_tum}).out);
  const auto found = nlohmann::json::parse(
      RunCommand({EVALUATE_TRAJECTORY, "--truth=" + kitti, "--trajectory=" + off}).out);
  EXPECT_EQ(found["ate"], expected["ate"]);
  EXPECT_EQ(found["rpe"], expected["rpe"]);
  EXPECT_EQ(
      ErrorOf({EVALUATE_TRAJECTORY, "--truth=" + kitti, "--trajectory=" + off, "--rpe_unit=s"}),
      "evaluate_trajectory: error: --rpe_unit=s: expected files with stamps (TUM), found " + kitti +
          " without (KITTI)\n");
}

TEST_F(EvaluateTrajectoryApp, BadInputAndBadFlagsAreOneLine) {
  const std::string truth = "--truth=" + poses_, poses = "--trajectory=" + poses_;
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, poses}), HasSubstr("--truth"));
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, truth}), HasSubstr("--trajectory"));
  EXPECT_EQ(
      ErrorOf({EVALUATE_TRAJECTORY, truth, poses, "--align=sim3"}),
      "evaluate_trajectory: error: --align: expected one of first, none, se2, found 'sim3'\n");
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, truth, poses, "--rpe_unit=km"}), HasSubstr("'km'"));
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, truth, poses, "--rpe_delta=0.5"}), HasSubstr("step"));
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, truth, poses, "--rpe_delta=5"}), HasSubstr("step"));
  const std::string later = folder_.FileWith("later.tum", "100 0 0 0 0 0 0 1\n");
  EXPECT_THAT(
      ErrorOf({EVALUATE_TRAJECTORY, truth, "--trajectory=" + later}),
      AllOf(HasSubstr("no pose could be associated"), HasSubstr(poses_ + " has stamps from "),
            HasSubstr(later + " has stamps from 100.000 to 100.000")));
  const std::string empty = folder_.FileWith("empty.tum", "# nothing\n");
  EXPECT_EQ(ErrorOf({EVALUATE_TRAJECTORY, truth, "--trajectory=" + empty}),
            "evaluate_trajectory: error: " + empty + ": holds no poses\n");
  EXPECT_EQ(ErrorOf({EVALUATE_TRAJECTORY, "--truth=" + empty, poses}),
            "evaluate_trajectory: error: " + empty + ": holds no poses\n");
  const std::string broken = folder_.FileWith("broken2.tum", "# t x y\n0 0 0\n");
  EXPECT_THAT(ErrorOf({EVALUATE_TRAJECTORY, "--truth=" + broken, poses}),
              HasSubstr(broken + ":2: expected 8 columns"));
}

TEST_F(EvaluateApps, HelpShowsTheFlagsOfTheProgramOnly) {
  const auto relations = RunCommand({EVALUATE_RELATIONS, "--help"});
  EXPECT_EQ(relations.status, 0);
  EXPECT_EQ(relations.err, "");
  EXPECT_THAT(relations.out, HasSubstr("-max_gap_s"));
  EXPECT_THAT(relations.out, HasSubstr("-relations"));
  EXPECT_THAT(relations.out, Not(HasSubstr("-minloglevel")));
  const auto trajectory = RunCommand({EVALUATE_TRAJECTORY, "--help"});
  EXPECT_EQ(trajectory.status, 0);
  EXPECT_THAT(trajectory.out, HasSubstr("-rpe_unit"));
  const auto full = RunCommand({EVALUATE_TRAJECTORY, "--helpfull"});
  EXPECT_EQ(full.status, 0);
  EXPECT_THAT(full.out, HasSubstr("-minloglevel"));
}

TEST_F(EvaluateApps, VersionIsPrinted) {
  const auto result = RunCommand({EVALUATE_RELATIONS, "--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, StartsWith("evaluate_relations version "));
}

}  // namespace
}  // namespace gmapping_spa::apps
