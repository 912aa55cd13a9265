// SPDX-License-Identifier: BSD-3-Clause
// What the connections of a server share: its options, its files, and who is there.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_CONNECTIONS_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_CONNECTIONS_H_

#include <atomic>
#include <set>
#include <utility>
#include <vector>

#include "experiments/view/conversation.h"
#include "experiments/view/static_file.h"
#include "experiments/view/view_server.h"

namespace gmapping_spa::view {

class WebSocketSession;

// Used in the server's thread, but for `clients`.
struct Connections {
  Connections(ServerOptions the_options, std::vector<StaticFile> the_files,
              std::vector<Protocol> the_protocols)
      : options(std::move(the_options)),
        files(std::move(the_files)),
        protocols(std::move(the_protocols)) {}

  const ServerOptions options;
  const std::vector<StaticFile> files;
  const std::vector<Protocol> protocols;
  int connections = 0;
  std::atomic<int> clients = 0;
  std::set<WebSocketSession*> sessions;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_CONNECTIONS_H_
