// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/message_of.h"

namespace gmapping_spa::backend::settings_test {
namespace {

constexpr SettingDescription kDescriptions[] = {
    NumberSetting("radius", "2.5", "a number", 0.0),
    NumberSetting("share", "0.5", "a number with both bounds", 0.0, 1.0),
    IntegerSetting("threads", "3", "an integer", 1), BooleanSetting("verbose", "true", "a truth"),
    ChoiceSetting("solver", "slow", "slow,fast", "a word")};

std::string ErrorOf(const std::string& name, const std::string& value) {
  return MessageOf([&] { Settings(kDescriptions, {{name, value}}); });
}

TEST(Settings, ReadsValuesOfEachType) {
  const Settings settings(
      kDescriptions,
      {{"radius", "1e-3"}, {"threads", "7"}, {"verbose", "false"}, {"solver", "fast"}});
  EXPECT_EQ(settings.Number("radius"), 1e-3);
  EXPECT_EQ(settings.Integer("threads"), 7);
  EXPECT_FALSE(settings.Boolean("verbose"));
  EXPECT_EQ(settings.Choice("solver"), "fast");
}

TEST(Settings, HasTheDefaultsWhereNothingIsGiven) {
  const Settings settings(kDescriptions, {});
  EXPECT_EQ(settings.Number("radius"), 2.5);
  EXPECT_EQ(settings.Integer("threads"), 3);
  EXPECT_TRUE(settings.Boolean("verbose"));
  EXPECT_EQ(settings.Choice("solver"), "slow");
}

TEST(Settings, RefusesValuesOfAnotherTypeOrOutOfRange) {
  for (const char* text : {"", "x", "1x", "nan", "inf", "-1", "1 ", "TRUE"}) {
    for (const char* name : {"radius", "share", "threads", "verbose", "solver"}) {
      EXPECT_NE(ErrorOf(name, text), "no error") << name << " " << text;
    }
  }
  EXPECT_EQ(ErrorOf("share", "1.5"), "setting share: expected a number from 0 to 1, got '1.5'");
  EXPECT_EQ(ErrorOf("threads", "0"), "setting threads: expected an integer of at least 1, got '0'");
  EXPECT_EQ(ErrorOf("threads", "1.5"),
            "setting threads: expected an integer of at least 1, got '1.5'");
  EXPECT_EQ(ErrorOf("solver", "fastest"),
            "setting solver: expected one of slow, fast, got 'fastest'");
}

TEST(Settings, RefusesNamesThatAreNotDescribed) {
  EXPECT_EQ(ErrorOf("slover", "fast"),
            "unknown setting slover: expected one of radius, share, threads, verbose, solver");
  EXPECT_THROW(Settings({}, {{"any", "1"}}), std::runtime_error);
}

TEST(Settings, TakesItForAnErrorOfTheProgrammerToReadWhatIsNotDescribed) {
  const Settings settings(kDescriptions, {});
  EXPECT_THROW(settings.Number("diameter"), std::logic_error);
  EXPECT_THROW(settings.Integer("radius"), std::logic_error);
}

}  // namespace
}  // namespace gmapping_spa::backend::settings_test
