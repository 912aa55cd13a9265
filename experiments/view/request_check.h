// SPDX-License-Identifier: BSD-3-Clause
// Whose requests are answered: no page of another origin gets to see or to steer a run.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_REQUEST_CHECK_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_REQUEST_CHECK_H_

#include <string>
#include <string_view>

namespace gmapping_spa::view {

// Whether the header Host names this machine, with any port: a tunnel has one of its own. A page
// whose name was made to lead here (DNS rebinding) sends that name. Allowed are localhost and
// addresses of the loopback, the address that the server is bound to, and any address, but no name,
// where it is bound to all of them.
bool IsOwnHost(std::string_view host, const std::string& bound_address);

// Whether the header Origin is that of a page that this server served under this Host.
bool IsSameOrigin(std::string_view origin, std::string_view host);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_REQUEST_CHECK_H_
