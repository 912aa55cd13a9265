// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/flag_help.h"

#include <gflags/gflags.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

DEFINE_double(size_m, 0.05, "Size of <things> & the like, in m.");
DEFINE_string(color, "", "Color.");
DEFINE_bool(ungrouped, false, "A flag of a library.");

namespace gmapping_spa::apps {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const FlagGroups& Groups() {
  static const auto& groups =
      *new FlagGroups{{"size", "Size & weight", {"size_m"}}, {"look", "Looks", {"color"}}};
  return groups;
}

TEST(FlagHelp, ShowsGroupsInTheirOrderUnderTheirTitles) {
  std::ostringstream out;
  PrintHelp("tool", Groups(), out);
  EXPECT_THAT(out.str(), AllOf(testing::StartsWith("tool: "),
                               testing::ContainsRegex("\nSize & weight:\n    -size_m [^\n]*\n(   "
                                                      "[^\n]*\n)*\nLooks:\n    -color ")));
}

TEST(FlagHelp, ShowsDefaultsAsPeopleWriteThem) {
  std::ostringstream out;
  PrintHelp("tool", Groups(), out);
  EXPECT_THAT(out.str(), HasSubstr("default: 0.05\n"));
}

TEST(FlagHelp, LeavesOutWhatIsInNoGroup) {
  std::ostringstream text, xml;
  PrintHelp("tool", Groups(), text);
  PrintHelpXml("tool", Groups(), xml);
  for (const std::string& shown : {text.str(), xml.str()}) {
    EXPECT_THAT(shown, AllOf(Not(HasSubstr("ungrouped")), Not(HasSubstr("minloglevel"))));
  }
}

TEST(FlagHelp, XmlNestsFlagsInGroupsAndEscapesTexts) {
  std::ostringstream out;
  PrintHelpXml("tool", Groups(), out);
  EXPECT_THAT(
      out.str(),
      AllOf(testing::StartsWith("<?xml version=\"1.0\"?>\n<AllFlags>\n<program>tool</program>\n"),
            HasSubstr("<group><name>size</name><title>Size &amp; weight</title>\n"
                      "<flag><name>size_m</name>"
                      "<meaning>Size of &lt;things&gt; &amp; the like, in m.</meaning>"),
            HasSubstr("<type>double</type></flag>\n</group>\n<group><name>look</name>"),
            testing::EndsWith("</group>\n</AllFlags>\n")));
}

}  // namespace
}  // namespace gmapping_spa::apps
