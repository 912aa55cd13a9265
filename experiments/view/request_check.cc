// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/request_check.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <cctype>

namespace gmapping_spa::view {
namespace {

using boost::asio::ip::address;

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// "name:80" and "[::1]:80" without the port and the brackets.
std::string NameOfHost(std::string_view host) {
  if (host.starts_with('[')) return LowerCase(host.substr(1, host.find(']') - 1));
  return LowerCase(host.substr(0, host.find(':')));
}

}  // namespace

bool IsOwnHost(std::string_view host, const std::string& bound_address) {
  const std::string name = NameOfHost(host);
  if (name == "localhost") return true;
  boost::system::error_code no_address;
  const address named = boost::asio::ip::make_address(name, no_address);
  if (no_address) return false;
  const address bound = boost::asio::ip::make_address(bound_address, no_address);
  return named.is_loopback() || (!no_address && (named == bound || bound.is_unspecified()));
}

bool IsSameOrigin(std::string_view origin, std::string_view host) {
  const std::string lower_host = LowerCase(host);
  const std::string lower_origin = LowerCase(origin);
  return lower_origin == "http://" + lower_host || lower_origin == "https://" + lower_host;
}

}  // namespace gmapping_spa::view
