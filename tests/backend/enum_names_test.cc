// SPDX-License-Identifier: BSD-3-Clause
#include "backend/enum_names.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace gmapping_spa::backend {
namespace {

enum class Color { kRed, kGreen, kUnnamed };
constexpr EnumName<Color> kColors[] = {{"red", Color::kRed}, {"green", Color::kGreen}};

TEST(EnumNames, LeadBothWays) {
  EXPECT_STREQ(NameOf(kColors, Color::kGreen), "green");
  EXPECT_EQ(ValueOf(kColors, "green"), Color::kGreen);
  EXPECT_EQ(FromName(kColors, "red", "a color"), Color::kRed);
}

TEST(EnumNames, KnowNothingElse) {
  EXPECT_STREQ(NameOf(kColors, Color::kUnnamed), "unknown");
  EXPECT_EQ(ValueOf(kColors, "gree"), std::nullopt);
  EXPECT_EQ(ValueOf(kColors, ""), std::nullopt);
}

TEST(EnumNames, AreListedWhereANameIsNone) {
  try {
    FromName(kColors, "blue", "a color");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), std::string("expected a color out of red, green, got 'blue'"));
  }
}

}  // namespace
}  // namespace gmapping_spa::backend
