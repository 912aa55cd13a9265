// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/plugin_abi.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace gmapping_spa::backend {
namespace {

// A plugin of version 2 may have been built years ago: what it shares with the program stays where
// it was, or the version is raised. Sizes are those of platforms with 64 bits.
TEST(PluginAbi, IsLaidOutAsInTheFirstPluginsOfVersion2) {
  static_assert(GMAPPING_SPA_PLUGIN_ABI_VERSION == 2);
  static_assert(sizeof(void*) == 8);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, abi_version), 0u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, name), 8u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, description), 16u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, settings), 24u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, setting_count), 32u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, losses), 40u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, create), 48u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, destroy), 56u);
  EXPECT_EQ(offsetof(GmappingSpaPlugin, optimize), 64u);
  EXPECT_EQ(sizeof(GmappingSpaPlugin), 72u);
  EXPECT_EQ(sizeof(GmappingSpaNode), 48u);
  EXPECT_EQ(offsetof(GmappingSpaNode, fixed), 40u);
  EXPECT_EQ(sizeof(GmappingSpaEdge), 120u);
  EXPECT_EQ(offsetof(GmappingSpaEdge, information), 40u);
  EXPECT_EQ(offsetof(GmappingSpaEdge, kind), 112u);
  EXPECT_EQ(sizeof(GmappingSpaGraph), 32u);
  EXPECT_EQ(sizeof(GmappingSpaOptions), 64u);
  EXPECT_EQ(sizeof(GmappingSpaReport), 24u);
  EXPECT_EQ(sizeof(GmappingSpaIteration), 40u);
  EXPECT_EQ(sizeof(GmappingSpaSettingDescription), 56u);
}

}  // namespace
}  // namespace gmapping_spa::backend
