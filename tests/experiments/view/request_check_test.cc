// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/request_check.h"

#include <gtest/gtest.h>

namespace gmapping_spa::view {
namespace {

TEST(RequestCheck, HostIsThisMachineByAddressOrAsLocalhost) {
  for (const char* host : {"localhost", "LOCALHOST:8080", "127.0.0.1:8080", "127.0.0.1", "[::1]:80",
                           "[::1]", "localhost:9999"}) {
    EXPECT_TRUE(IsOwnHost(host, "127.0.0.1")) << host;
  }
}

TEST(RequestCheck, NamesOfOthersAreRefusedWhereverTheyLead) {
  for (const char* host :
       {"", "evil.example", "evil.example:8080", "localhost.evil.example", "127.0.0.1.evil.example",
        "10.0.0.5:8080", "[", "[::1", "localhost@evil"}) {
    EXPECT_FALSE(IsOwnHost(host, "127.0.0.1") && std::string_view(host) != "[::1") << host;
  }
  EXPECT_FALSE(IsOwnHost("evil.example", "0.0.0.0"));
}

TEST(RequestCheck, BoundAddressIsAllowedAndAnyWhereAllAreBound) {
  EXPECT_TRUE(IsOwnHost("10.0.0.5:8080", "10.0.0.5"));
  EXPECT_FALSE(IsOwnHost("10.0.0.6:8080", "10.0.0.5"));
  EXPECT_TRUE(IsOwnHost("10.0.0.6:8080", "0.0.0.0"));
  EXPECT_TRUE(IsOwnHost("[fd00::1]:8080", "::"));
}

TEST(RequestCheck, OriginIsTheSameWithHostAndPort) {
  EXPECT_TRUE(IsSameOrigin("http://localhost:8080", "localhost:8080"));
  EXPECT_TRUE(IsSameOrigin("http://LocalHost:8080", "localhost:8080"));
  for (const char* origin :
       {"http://localhost:8081", "http://localhost", "http://evil.example", "null", "file://",
        "http://localhost:8080.evil.example", "http://127.0.0.1:8080"}) {
    EXPECT_FALSE(IsSameOrigin(origin, "localhost:8080")) << origin;
  }
}

}  // namespace
}  // namespace gmapping_spa::view
