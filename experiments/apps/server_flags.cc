// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/server_flags.h"

#include <gflags/gflags.h>

#include <iostream>
#include <string>

#include "experiments/apps/flag_checks.h"

DEFINE_int32(view_port, 8080, "Port of the page, from 0; 0 takes one that is free.");
DEFINE_string(
    view_address, "127.0.0.1",
    "Address of this machine, in numbers, at which the page is served. The default is for "
    "this machine alone; 0.0.0.0 is for everybody who can reach it, without a password.");

namespace gmapping_spa::apps {

FlagGroups ServerFlagGroups() { return {{"page", "Page", {"view_port", "view_address"}}}; }

view::ServerOptions ServerOptionsFromFlags() {
  view::ServerOptions options;
  options.address = FLAGS_view_address;
  options.port = static_cast<std::uint16_t>(InRange("view_port", FLAGS_view_port, 0, 65535));
  return options;
}

void SayWhereThePageIs(std::uint16_t port) {
  const bool is_ipv6 = FLAGS_view_address.find(':') != std::string::npos;
  std::cerr << "view: http://" << (is_ipv6 ? "[" + FLAGS_view_address + "]" : FLAGS_view_address)
            << ':' << port << "/\n";
}

}  // namespace gmapping_spa::apps
