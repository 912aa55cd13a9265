// SPDX-License-Identifier: BSD-3-Clause
// What a program complains about.
#ifndef GMAPPING_SPA_TESTS_COMMAND_ERROR_H_
#define GMAPPING_SPA_TESTS_COMMAND_ERROR_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/run_command.h"

namespace gmapping_spa {

// Runs `words` and checks that they fail as bad input does: status 1, nothing on stdout, one line
// on stderr, which is returned.
inline std::string ErrorOf(const std::vector<std::string>& words) {
  const CommandResult result = RunCommand(words);
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  return result.err;
}

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_COMMAND_ERROR_H_
