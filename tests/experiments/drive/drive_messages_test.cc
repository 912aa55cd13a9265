// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/drive_messages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace gmapping_spa::drive {
namespace {

class TakeWishTest : public testing::Test {
 protected:
  DriveWishes Take(const std::string& text) {
    DriveTitle title;
    title.backends = {"spa", "none"};
    TakeWish(text, /*is_binary=*/false, title, &controls_);
    return controls_.Take();
  }
  DriveControls controls_{DriveWishes{}};
};

TEST_F(TakeWishTest, KeysAreHeldUntilTheyAreNot) {
  EXPECT_EQ(Take(R"({"op": "hold", "forward": 1, "left": -1})").left, -1.0);
  EXPECT_EQ(controls_.Take().forward, 1.0);
  EXPECT_FALSE(Take(R"({"op": "hold", "forward": 0, "left": 0})").holds());
}

TEST_F(TakeWishTest, KeysOfAPageThatSaysNothingAreLetGoAfterASecond) {
  const auto now = DriveControls::Clock::now();
  const auto in = [&](int ms) { return now + std::chrono::milliseconds(ms); };
  controls_.Hold(1.0, -1.0, now);
  EXPECT_TRUE(controls_.Take(in(900)).holds());
  controls_.Hold(1.0, -1.0, in(950));  // as it says again and again
  EXPECT_EQ(controls_.Take(in(1900)).forward, 1.0);
  const DriveWishes silent = controls_.Take(in(2000));
  EXPECT_EQ(silent.forward, 0.0);
  EXPECT_EQ(silent.left, 0.0);
  EXPECT_FALSE(controls_.Take(in(950)).holds());  // and stay so
  controls_.Hold(1.0, 0.0, in(2500));
  EXPECT_TRUE(controls_.Take(in(2600)).holds());
}

TEST_F(TakeWishTest, GoalsSavesAndMapsCountOnce) {
  EXPECT_EQ(*Take(R"({"op": "goal", "x": 1.5, "y": 2})").goal, Eigen::Vector2d(1.5, 2.0));
  EXPECT_TRUE(Take(R"({"op": "save"})").save);
  const DriveWishes wishes =
      Take(R"({"op": "add", "backend": "none", "particles": 30, "correction": "pose"})");
  ASSERT_EQ(wishes.added.size(), 1u);
  EXPECT_EQ(wishes.added[0], (VariantChoice{"none", 30, SlamOptions::Correction::kPose}));
  EXPECT_EQ(Take(R"({"op": "remove", "run": 2})").removed, std::vector<int>{2});
  const DriveWishes after = controls_.Take();
  EXPECT_FALSE(after.goal || after.save || !after.added.empty() || !after.removed.empty());
}

TEST_F(TakeWishTest, NonsenseIsRefused) {
  for (const char* text :
       {"", "[]", "{}", R"({"op": 1})", R"({"op": "fly"})", R"({"op": "hold", "forward": 1})",
        R"({"op": "hold", "forward": 2, "left": 0})",
        R"({"op": "hold", "forward": "1", "left": 0})", R"({"op": "goal", "x": 1e9, "y": 0})",
        R"({"op": "odometry", "noise": -1, "slips": 0})", R"({"op": "remove", "run": 0})",
        R"({"op": "add", "backend": "/tmp/mine.so", "particles": 5, "correction": "pose"})",
        R"({"op": "add", "backend": "spa", "particles": 100000, "correction": "pose"})",
        R"({"op": "add", "backend": "spa", "particles": 5, "correction": "none"})"}) {
    EXPECT_THROW(Take(text), std::runtime_error) << text;
  }
}

TEST(DriveMessages, ScoresThatAreNotKnownAreNull) {
  const auto json = nlohmann::json::parse(
      VariantsMessage({{1, {{"spa", 5}, "following", {2.0, 0.01, {}}}}})->data);
  EXPECT_EQ(json["list"][0]["run"], 1);
  EXPECT_EQ(json["list"][0]["name"], "spa, 5 particles, trajectory");
  EXPECT_EQ(json["list"][0]["ate_m"], 0.01);
  EXPECT_TRUE(json["list"][0]["iou"].is_null());
}

TEST(DriveMessages, ScoresSoFarAreRowsForTheChart) {
  VariantStatus variant;
  variant.scores.Add({1.0, 0.01, {}});
  variant.scores.Add({2.5, 0.02, 0.9});
  const auto json = nlohmann::json::parse(ScoresMessage(3, variant)->data);
  EXPECT_EQ(json["run"], 3);
  EXPECT_EQ(json["rows"], nlohmann::json::parse("[[1.0, 0.01, null], [2.5, 0.02, 0.9]]"));
}

}  // namespace
}  // namespace gmapping_spa::drive
