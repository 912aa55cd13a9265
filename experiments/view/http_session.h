// SPDX-License-Identifier: BSD-3-Clause
// A connection as long as it speaks HTTP.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_HTTP_SESSION_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_HTTP_SESSION_H_

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "experiments/view/connections.h"

namespace gmapping_spa::view {

// Answers the requests that come in until it ends or becomes a WebSocketSession; keeps itself alive
// for so long. Counts as one of connections->connections.
void BeginHttpSession(boost::asio::ip::tcp::socket socket,
                      const std::shared_ptr<Connections>& connections);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_HTTP_SESSION_H_
