// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/flag_groups.h"

#include <gflags/gflags.h>
#include <glog/logging.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/run_command.h"

namespace gmapping_spa::apps {
namespace {

// What the first group of `pattern` matches, one after the other.
std::vector<std::string> Matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

// Of gflags and glog: this program has no flags of its own but those of GoogleTest, which are not
// gflags.
std::set<std::string> FlagsOfLibraries() {
  google::FlushLogFiles(google::INFO);  // links glog
  std::vector<gflags::CommandLineFlagInfo> flags;
  gflags::GetAllFlags(&flags);
  std::set<std::string> names;
  for (const gflags::CommandLineFlagInfo& flag : flags) names.insert(flag.name);
  return names;
}

class FlagGroupsOf : public testing::TestWithParam<std::string> {
 protected:
  static std::string Help(const char* flag) {
    return RunCommand({PROGRAMS_FOLDER "/" + GetParam(), flag}).out;
  }
};

TEST_P(FlagGroupsOf, HoldEachFlagOfTheProgramOnce) {
  const std::set<std::string> libraries = FlagsOfLibraries();
  ASSERT_TRUE(libraries.contains("flagfile") && libraries.contains("minloglevel"));
  std::vector<std::string> own;
  for (const std::string& name : Matches(Help("--helpfull"), "\n    -([a-z0-9_]+) ")) {
    if (!libraries.contains(name)) own.push_back(name);
  }
  EXPECT_GE(own.size(), 3u);
  EXPECT_THAT(Matches(Help("--helpxml"), "<flag><name>([^<]*)"),
              testing::UnorderedElementsAreArray(own));
}

TEST_P(FlagGroupsOf, AreShownByHelpAsByHelpxml) {
  const std::string xml = Help("--helpxml"), text = Help("--help");
  EXPECT_EQ(Matches(text, "\n    -([a-z0-9_]+) "), Matches(xml, "<flag><name>([^<]*)"));
  EXPECT_EQ(Matches(text, "\n\n([^\n]+):\n    -"), Matches(xml, "<title>([^<]*)"));
}

TEST_P(FlagGroupsOf, HaveNamesOfTheirOwn) {
  const std::vector<std::string> names = Matches(Help("--helpxml"), "<group><name>([^<]*)");
  EXPECT_GE(names.size(), 2u);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

INSTANTIATE_TEST_SUITE_P(Programs, FlagGroupsOf, testing::ValuesIn(Matches(PROGRAMS, "([a-z_]+)")),
                         [](const auto& program) { return program.param; });

TEST(FlagGroups, AreJoinedInOrder) {
  const FlagGroups joined = Join({{{"a", "A", {"x"}}, {"b", "B", {}}}, {}, {{"c", "C", {"y"}}}});
  ASSERT_EQ(joined.size(), 3u);
  EXPECT_EQ(joined[0].name + joined[1].name + joined[2].name, "abc");
  EXPECT_EQ(joined[2].flags, std::vector<std::string>{"y"});
}

}  // namespace
}  // namespace gmapping_spa::apps
