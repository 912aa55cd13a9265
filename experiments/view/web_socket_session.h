// SPDX-License-Identifier: BSD-3-Clause
// A connection once it is a WebSocket.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_WEB_SOCKET_SESSION_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_WEB_SOCKET_SESSION_H_

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstddef>
#include <deque>
#include <memory>

#include "experiments/view/connections.h"
#include "experiments/view/http_answer.h"

namespace gmapping_spa::view {

// Keeps itself alive as long as it is open. What waits to be sent is bounded by who sends: see
// Peer::IsBehind.
class WebSocketSession : public Peer, public std::enable_shared_from_this<WebSocketSession> {
 public:
  WebSocketSession(boost::asio::ip::tcp::socket socket, std::shared_ptr<Connections> connections);
  ~WebSocketSession() override;
  WebSocketSession(const WebSocketSession&) = delete;
  WebSocketSession& operator=(const WebSocketSession&) = delete;

  void Accept(const HttpRequest& request, const Protocol& protocol);

  void Send(MessagePtr message) override;
  bool IsBehind() const override {
    return waiting_bytes_ > connections_->options.max_waiting_bytes;
  }
  bool HasSentAll() const { return waiting_.empty(); }
  void Close();

 private:
  void Read();
  void OnMessage();
  void Write();
  void OnWritten();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  std::shared_ptr<Connections> connections_;
  boost::beast::flat_buffer buffer_;
  std::unique_ptr<Conversation> conversation_;
  std::deque<MessagePtr> waiting_;  // the first one is being sent
  std::size_t waiting_bytes_ = 0;
  bool is_closing_ = false;
};

// Counts as one of connections->clients from here on. `protocol` is one of the connections'.
void BeginWebSocketSession(boost::asio::ip::tcp::socket socket, const HttpRequest& request,
                           const Protocol& protocol,
                           const std::shared_ptr<Connections>& connections);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_WEB_SOCKET_SESSION_H_
