#include "backend/plugin/settings.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gmapping_spa::backend {
namespace {

using Settings = std::map<std::string, std::string>;

TEST(SettingsReader, ReadsValuesOfEachKind) {
  const Settings settings = {{"a", "1e-3"}, {"b", "7"}, {"c", "true"}, {"d", "fast"}};
  SettingsReader reader(settings);
  EXPECT_EQ(reader.Number("a", 0.0, 0.0), 1e-3);
  EXPECT_EQ(reader.Integer("b", 0, 0), 7);
  EXPECT_TRUE(reader.Flag("c", false));
  EXPECT_EQ(reader.Choice("d", {"slow", "fast"}), "fast");
  EXPECT_NO_THROW(reader.RejectOthers());
}

TEST(SettingsReader, FallsBackWhereNothingIsSet) {
  const Settings none;
  SettingsReader reader(none);
  EXPECT_EQ(reader.Number("a", 2.5, 0.0), 2.5);
  EXPECT_EQ(reader.Integer("b", 3, 0), 3);
  EXPECT_TRUE(reader.Flag("c", true));
  EXPECT_EQ(reader.Choice("d", {"slow", "fast"}), "slow");
}

TEST(SettingsReader, RejectsValuesOfAnotherKind) {
  for (const char* text : {"", "x", "1x", "nan", "inf", "-1", "1 "}) {
    const Settings settings = {{"a", text}};
    SettingsReader reader(settings);
    EXPECT_THROW(reader.Number("a", 0.0, 0.0), std::runtime_error) << text;
    EXPECT_THROW(reader.Integer("a", 0, 0), std::runtime_error) << text;
    EXPECT_THROW(reader.Flag("a", false), std::runtime_error) << text;
    EXPECT_THROW(reader.Choice("a", {"slow", "fast"}), std::runtime_error) << text;
  }
}

TEST(SettingsReader, RejectsNamesNobodyAskedFor) {
  const Settings settings = {{"solver", "block"}, {"slover", "block"}};
  SettingsReader reader(settings);
  reader.Choice("solver", {"block"});
  EXPECT_THROW(reader.RejectOthers(), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::backend
