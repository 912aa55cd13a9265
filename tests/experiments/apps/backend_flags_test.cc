// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/backend_flags.h"

#include <gflags/gflags.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "backend/plugin/plugin_loader.h"

namespace gmapping_spa::apps {
namespace {

class BackendFlags : public testing::Test {
 private:
  gflags::FlagSaver saver_;
};

bool SameValue(const std::string& a, const std::string& b) {
  return a == b || (a.find_first_of("0123456789") == 0 && std::stod(a) == std::stod(b));
}

TEST_F(BackendFlags, HaveTheSettingsOfBackEndsWithTheirDefaults) {
  int settings = 0;
  for (const backend::BackendDescription& backend : backend::ListBackends({GMAPPING_SPA_PLUGINS})) {
    for (const backend::SettingDescription& setting : backend.settings) {
      const std::string name = backend.name + "_" + setting.name;
      gflags::CommandLineFlagInfo flag;
      ASSERT_TRUE(gflags::GetCommandLineFlagInfo(name.c_str(), &flag)) << name;
      EXPECT_TRUE(SameValue(flag.default_value, setting.default_value))
          << name << ": " << flag.default_value << " and " << setting.default_value;
      ++settings;
    }
  }
  EXPECT_GE(settings, 3);
}

TEST_F(BackendFlags, RefuseASettingThatTheBackEndDoesNotHaveBeforeItIsUsed) {
  gflags::SetCommandLineOption("backend", "none");
  gflags::SetCommandLineOption("backend_settings", "solver=block");
  EXPECT_THROW(LoadOptimizerFromFlags(), std::runtime_error);
  gflags::SetCommandLineOption("backend", "spa");
  EXPECT_NO_THROW(LoadOptimizerFromFlags());
  gflags::SetCommandLineOption("backend_settings", "solver=blok");
  EXPECT_THROW(LoadOptimizerFromFlags(), std::runtime_error);
}

TEST_F(BackendFlags, TakeNoTimeForNoLimitOfTime) {
  EXPECT_EQ(OptionsFromFlags().max_solver_time_s, std::numeric_limits<double>::infinity());
  gflags::SetCommandLineOption("max_solver_time_s", "0.5");
  EXPECT_EQ(OptionsFromFlags().max_solver_time_s, 0.5);
  gflags::SetCommandLineOption("max_solver_time_s", "-1");
  EXPECT_THROW(OptionsFromFlags(), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::apps
