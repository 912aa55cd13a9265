// SPDX-License-Identifier: BSD-3-Clause
// A small web server in a thread of its own: files from memory, and conversations over WebSockets.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_VIEW_SERVER_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_VIEW_SERVER_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "experiments/view/conversation.h"
#include "experiments/view/static_file.h"

namespace gmapping_spa::view {

struct ServerOptions {
  std::string address = "127.0.0.1";  // of the interface that is listened at
  std::uint16_t port = 0;             // 0: any that is free
  // Origins of other pages that may speak protocols that only read.
  std::vector<std::string> reading_origins;
  int max_clients = 32;                     // WebSockets; the next one gets 503
  int max_connections = 128;                // of all kinds; the next one is closed at once
  std::size_t max_message_bytes = 4096;     // from a client; a longer one ends its conversation
  std::size_t max_waiting_bytes = 4 << 20;  // Peer::IsBehind from here on
};

class ViewServer {
 public:
  // Listens when it returns. Throws std::runtime_error with one line where that is not possible.
  // `files` are those of the whole site, "/" included; what they point to outlives the server.
  ViewServer(const ServerOptions& options, std::vector<StaticFile> files,
             std::vector<Protocol> protocols);
  // Ends all conversations.
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  std::uint16_t port() const;

  // WebSockets that are open. In any thread, at the price of reading a number.
  int CountClients() const;

  // Runs `work` in the server's thread, in which conversations run.
  void Post(std::function<void()> work);

  // Waits until all clients have been sent what waits for them, but for so long at most.
  void Drain(std::chrono::milliseconds patience);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_VIEW_SERVER_H_
