// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "experiments/ros/node_flags.h"
#include "tests/message_of.h"

namespace gmapping_spa::ros {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

NodeParameters Read(const std::map<std::string, std::string>& parameters) {
  return ReadParameters(parameters, NodeFlagGroups());
}

TEST(Parameters, OfSlamGmappingBecomeFlags) {
  const NodeParameters read = Read({{"particles", "30"},
                                    {"linearUpdate", "0.5"},
                                    {"angularUpdate", "0.25"},
                                    {"delta", "0.1"},
                                    {"occ_thresh", "0.3"},
                                    {"str", "0.5"},
                                    {"srt", "0.75"}});
  EXPECT_THAT(read.flags,
              UnorderedElementsAre(
                  "--particles=30", "--linear_update_m=0.5", "--angular_update_rad=0.25",
                  "--resolution_m=0.10000000000000001", "--occupied_threshold=0.29999999999999999",
                  "--motion_linear_per_angular=0.5", "--motion_angular_per_linear=0.75"));
  EXPECT_THAT(read.refusals, IsEmpty());
}

TEST(Parameters, OfTheNodeAreItsOptions) {
  const NodeOptions node = Read({{"map_frame", "/world"},
                                 {"throttle_scans", "3"},
                                 {"map_update_interval", "2.5"},
                                 {"transform_publish_period", "0"},
                                 {"tf_delay", "0.1"},
                                 {"minimumScore", "50"},
                                 {"exit_on_time_jump", "true"}})
                               .node;
  EXPECT_EQ(node.map_frame, "world");
  EXPECT_EQ(node.throttle_scans, 3);
  EXPECT_EQ(node.map_update_interval_s, 2.5);
  EXPECT_EQ(node.transform_publish_period_s, 0.0);
  EXPECT_EQ(node.tf_delay_s, 0.1);
  EXPECT_EQ(node.minimum_score, 50.0);
  EXPECT_TRUE(node.exit_on_time_jump);
}

TEST(Parameters, WithoutCounterpartAreRefusedWithAReason) {
  EXPECT_THAT(Read({{"xmin", "-100"}}).refusals,
              ElementsAre("~xmin is not used: maps grow with what is seen"));
  EXPECT_THAT(Read({{"temporalUpdate", "3.0"}}).refusals, ElementsAre(HasSubstr("motion decides")));
  EXPECT_THAT(Read({{"lskip", "2"}}).refusals, ElementsAre(HasSubstr("every beam")));
  EXPECT_THAT(Read({{"linear_updates", "2"}}).refusals, ElementsAre(HasSubstr("neither")));
}

TEST(Parameters, ThatAskForNothingElseAreNotRefused) {
  EXPECT_THAT(Read({{"temporalUpdate", "-1.0"},
                    {"lskip", "0"},
                    {"kernelSize", "1"},
                    {"inverted_laser", "false"}})
                  .refusals,
              IsEmpty());
}

// All that the page of slam_gmapping lists, and its program reads.
TEST(Parameters, OfSlamGmappingAreAllKnown) {
  for (const char* name : {"throttle_scans",
                           "base_frame",
                           "map_frame",
                           "odom_frame",
                           "map_update_interval",
                           "maxUrange",
                           "maxRange",
                           "sigma",
                           "kernelSize",
                           "lstep",
                           "astep",
                           "iterations",
                           "lsigma",
                           "ogain",
                           "lskip",
                           "minimumScore",
                           "srr",
                           "srt",
                           "str",
                           "stt",
                           "linearUpdate",
                           "angularUpdate",
                           "temporalUpdate",
                           "resampleThreshold",
                           "particles",
                           "xmin",
                           "ymin",
                           "xmax",
                           "ymax",
                           "delta",
                           "llsamplerange",
                           "llsamplestep",
                           "lasamplerange",
                           "lasamplestep",
                           "transform_publish_period",
                           "occ_thresh",
                           "tf_delay",
                           "seed",
                           "inverted_laser"}) {
    for (const std::string& line : Read({{name, "1"}}).refusals) {
      EXPECT_THAT(line, Not(HasSubstr("neither")));
    }
  }
}

TEST(Parameters, OfRangesClearTheMapWhereTheLaserReachesFartherThanIsUsed) {
  EXPECT_THAT(Read({{"maxUrange", "8"}, {"maxRange", "10"}}).flags,
              ElementsAre("--usable_range_m=8", "--no_return_clears"));
  EXPECT_THAT(Read({{"maxUrange", "8"}, {"maxRange", "8"}}).flags,
              ElementsAre("--usable_range_m=8"));
  EXPECT_THAT(Read({{"maxRange", "10"}}).flags, ElementsAre("--usable_range_m=10"));
}

// As experiments/flags/gmapping.flags has them.
TEST(Parameters, InOtherUnitsAreConverted) {
  EXPECT_THAT(Read({{"sigma", "0.05"}}).flags, ElementsAre(HasSubstr("--score_sigma_m=0.158")));
  EXPECT_THAT(Read({{"lsigma", "0.075"}}).flags,
              ElementsAre(HasSubstr("--likelihood_sigma_m=0.1936")));
  EXPECT_THAT(Read({{"srr", "0.5"}}).flags,
              ElementsAre("--motion_linear_per_linear=0.5", HasSubstr("_lateral_per_linear=0.1")));
}

TEST(Parameters, OfTheFlagsOfGmappingSpaAreFlags) {
  EXPECT_THAT(Read({{"backend", "ceres"}, {"flagfile", "my.flags"}, {"base_frame", "base"}}).flags,
              UnorderedElementsAre("--backend=ceres", "--flagfile=my.flags", "--base_frame=base"));
}

TEST(Parameters, ThatMakeNoSenseAreErrors) {
  EXPECT_EQ(MessageOf([] {
              Read({{"throttle_scans", "none"}});
            }),
            "~throttle_scans: expected a number from 1 to 1e+06, found 'none'");
  EXPECT_EQ(MessageOf([] {
              Read({{"exit_on_time_jump", "2"}});
            }),
            "~exit_on_time_jump: expected true or false, found '2'");
  EXPECT_EQ(MessageOf([] {
              Read({{"localize", "maybe"}});
            }),
            "~localize: expected a value of type bool, found 'maybe'");
}

}  // namespace
}  // namespace gmapping_spa::ros
