// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/yaml_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/message_of.h"

namespace gmapping_spa::map {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class YamlFileTest : public ::testing::Test {
 protected:
  YamlFile Read(const std::string& text) {
    std::ofstream(path_) << text;
    return YamlFile(path_);
  }
  void TearDown() override { std::filesystem::remove(path_); }

  const std::string path_ = ::testing::TempDir() +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                            ".yaml";
};

TEST_F(YamlFileTest, GivesStringsNumbersAndLists) {
  const YamlFile yaml = Read("name: hall\nsize: [4, 2.5]\nheight: 3e-1\n");
  EXPECT_EQ(yaml.String("name"), "hall");
  EXPECT_EQ(yaml.Number("height"), 0.3);
  EXPECT_THAT(yaml.Numbers(yaml.Get("size"), 2, "[x, y]"), ElementsAre(4.0, 2.5));
  EXPECT_EQ(yaml.Items("size").size(), 2U);
  EXPECT_TRUE(yaml.Has("name"));
  EXPECT_FALSE(yaml.Has("width"));
}

TEST_F(YamlFileTest, FlagsAreBooleansOrZeroAndOne) {
  const YamlFile yaml = Read("a: false\nb: True\nc: 0\nd: 1\ne: 2\nf: perhaps\n");
  EXPECT_FALSE(yaml.Flag("a"));
  EXPECT_TRUE(yaml.Flag("b"));
  EXPECT_FALSE(yaml.Flag("c"));
  EXPECT_TRUE(yaml.Flag("d"));
  EXPECT_EQ(MessageOf([&] { yaml.Flag("e"); }),
            path_ + ":5: expected 0, 1, false or true for 'e', found '2'");
  EXPECT_THAT(MessageOf([&] { yaml.Flag("f"); }), HasSubstr("'perhaps'"));
}

TEST_F(YamlFileTest, ComplaintsNameTheFileAndTheLine) {
  const YamlFile yaml = Read("a: 1\nb: word\nc: .nan\nd: [1]\n");
  EXPECT_THAT(MessageOf([&] { yaml.Number("b"); }), StartsWith(path_ + ":2: "));
  EXPECT_THAT(MessageOf([&] { yaml.Number("c"); }), StartsWith(path_ + ":3: "));
  EXPECT_THAT(MessageOf([&] { yaml.Numbers(yaml.Get("d"), 2, "[x, y]"); }),
              ::testing::AllOf(StartsWith(path_ + ":4: "), HasSubstr("[x, y]")));
  EXPECT_THAT(MessageOf([&] { yaml.Items("a"); }), StartsWith(path_ + ":1: "));
}

TEST_F(YamlFileTest, MisspeltKeyIsRefusedWithThoseThatAreAllowed) {
  const YamlFile yaml = Read("size: 1\nresolutoin: 2\n");
  EXPECT_THAT(MessageOf([&] {
                yaml.AllowOnly({"size", "resolution"});
              }),
              ::testing::AllOf(StartsWith(path_ + ":2: "), HasSubstr("size, resolution"),
                               HasSubstr("'resolutoin'")));
  EXPECT_NO_THROW(yaml.AllowOnly({"size", "resolutoin", "boxes"}));
}

TEST_F(YamlFileTest, MissingKeyAndMissingFileAreErrors) {
  const YamlFile yaml = Read("a: 1\n");
  EXPECT_THAT(MessageOf([&] { yaml.Get("b"); }), HasSubstr("the key 'b'"));
  EXPECT_THAT(MessageOf([] { YamlFile("/nowhere.yaml"); }), StartsWith("/nowhere.yaml: "));
}

TEST_F(YamlFileTest, WhatIsNoTableOfKeysIsAnError) {
  EXPECT_THAT(MessageOf([&] { Read("[1, 2]\n"); }), HasSubstr("a table of keys"));
  EXPECT_THAT(MessageOf([&] { Read("a: [1\n"); }), HasSubstr("expected YAML"));
}

}  // namespace
}  // namespace gmapping_spa::map
