// SPDX-License-Identifier: BSD-3-Clause
// Going on in the map of another run with gmapping_spa, and being localized in it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class MapSessionTour : public GmappingSpaTour {
 protected:
  // The log has two halves: the map of the first one, which a session holds, and another day.
  void SetUp() override {
    const std::string log = Contents(Log());
    const std::size_t at = log.find('\n', log.size() / 2) + 1;
    first_log_ = folder_.FileWith("first.clf", log.substr(0, at));
    second_log_ = folder_.FileWith("second.clf", log.substr(at));
    Run(first_, {"--log=" + first_log_, "--save_session=" + session_});
  }

  void RunSecond(const std::string& folder, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"--log=" + second_log_, "--map_session=" + session_});
    Run(folder, more);
  }

  static std::int64_t Lines(const std::string& path) {
    const std::string text = Contents(path);
    return std::count(text.begin(), text.end(), '\n');
  }

  // Of both halves together: they are in one frame.
  double ErrorOfBothM(const std::string& second) const {
    const std::string both = folder_.Path("both");
    std::filesystem::create_directories(both);
    folder_.FileWith("both/trajectory.tum",
                     Contents(first_ + "/trajectory.tum") + Contents(second + "/trajectory.tum"));
    return ErrorM(both);
  }

  const std::string first_ = folder_.Path("a"), out_ = folder_.Path("out"),
                    session_ = folder_.Path("a.session");
  std::string first_log_, second_log_;
};

TEST_F(MapSessionTour, TheRobotIsLocalizedScanByScanAndTheMapStaysAsItIs) {
  RunSecond(out_, {"--localize"});
  EXPECT_TRUE(Contents(out_ + "/map.pgm") == Contents(first_ + "/map.pgm"));
  EXPECT_LT(ErrorOfBothM(out_), 0.05);
  const Json record = ReadRunRecord(out_);
  EXPECT_EQ(Lines(out_ + "/localization.csv"), 1 + record["counts"]["scans"].get<int>());
  EXPECT_EQ(record["session"]["found"].size(), 1u);
  EXPECT_EQ(record["session"]["map_is_fixed"], true);
  EXPECT_EQ(Lines(out_ + "/trajectory.tum") + record["session"]["scans_of_unknown_pose"].get<int>(),
            record["counts"]["scans"]);
}

TEST_F(MapSessionTour, MappedOnOldAndNewAreOneMap) {
  RunSecond(out_);
  EXPECT_LT(ErrorOfBothM(out_), 0.08);
  EXPECT_FALSE(std::filesystem::exists(out_ + "/localization.csv"));
  EXPECT_GT(Lines(out_ + "/graph.g2o"), Lines(first_ + "/graph.g2o"));
}

TEST_F(MapSessionTour, SessionsOfTwoLogsAreMergedByReadingOneAsALog) {
  const std::string second = folder_.Path("b.session");
  Run(folder_.Path("b"), {"--log=" + second_log_, "--save_session=" + second});
  Run(out_, {"--log=" + second, "--map_session=" + session_});
  EXPECT_LT(ErrorOfBothM(out_), 0.08);
}

TEST_F(MapSessionTour, OtherFlagsThanThoseOfTheMapMayBeUsed) {
  for (const std::string flag : {"--particles=2", "--correction=pose"}) {
    RunSecond(out_, {"--localize", flag, "--nofinal_optimization"});
    EXPECT_LT(ErrorOfBothM(out_), 0.1) << flag;
  }
  // Nothing but where it was found says where the piece lies, and which way it points.
  RunSecond(out_, {"--localize", "--backend=none", "--nofinal_optimization"});
  EXPECT_LT(ErrorOfBothM(out_), 0.5);
}

TEST_F(MapSessionTour, ARunInAMapIsGoneOnWithToTheSameBytes) {
  RunSecond(folder_.Path("whole"));
  const std::string log = Contents(second_log_);
  const std::string part =
      folder_.FileWith("part.clf", log.substr(0, log.find('\n', log.size() / 2) + 1));
  const std::string later = folder_.Path("later.session");
  RunSecond(folder_.Path("part"), {"--log=" + part, "--save_session=" + later});
  RunSecond(out_, {"--resume=" + later});
  ExpectSameResult(folder_.Path("whole"), out_);
}

TEST_F(MapSessionTour, WhatMakesNoSenseIsRefusedInOneLine) {
  const auto error_of = [&](const std::vector<std::string>& more) {
    const CommandResult result = RunCommand(Command(out_, more));
    EXPECT_EQ(result.status, 1);
    EXPECT_FALSE(std::filesystem::exists(out_));
    return result.err;
  };
  EXPECT_EQ(error_of({"--localize"}),
            "gmapping_spa: error: --localize needs --map_session=FILE: the map to localize in\n");
  EXPECT_THAT(error_of({"--map_session=" + session_, "--resolution_m=0.1"}),
              HasSubstr("--resolution_m=0.05, found --resolution_m=0.1\n"));
  EXPECT_THAT(error_of({"--save_session=" + folder_.Path("a")}), HasSubstr("a regular file"));
  EXPECT_THAT(error_of({"--map_session=" + first_log_}),
              StartsWith("gmapping_spa: error: " + first_log_ + ": expected "));
  const std::string both = folder_.Path("both.session");
  RunSecond(folder_.Path("c"), {"--save_session=" + both});
  EXPECT_THAT(error_of({"--log=" + both}), HasSubstr("give its logs one after another"));
  EXPECT_THAT(error_of({"--resume=" + session_, "--map_session=" + session_}),
              HasSubstr("expected the session of a run with --map_session"));
  EXPECT_THAT(error_of({"--resume=" + both, "--map_session=" + session_, "--localize"}),
              HasSubstr("--localize=false, found --localize=true"));
}

}  // namespace
}  // namespace gmapping_spa::apps
