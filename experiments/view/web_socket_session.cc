// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/web_socket_session.h"

#include <glog/logging.h>

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

namespace gmapping_spa::view {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

}  // namespace

WebSocketSession::WebSocketSession(boost::asio::ip::tcp::socket socket,
                                   std::shared_ptr<Connections> connections)
    : stream_(std::move(socket)), connections_(std::move(connections)) {
  ++connections_->connections;
  ++connections_->clients;
  connections_->sessions.insert(this);
}

WebSocketSession::~WebSocketSession() {
  conversation_.reset();
  connections_->sessions.erase(this);
  --connections_->clients;
  --connections_->connections;
}

void WebSocketSession::Accept(const HttpRequest& request, const Protocol& protocol) {
  // Who does not answer pings has gone.
  stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  stream_.set_option(
      websocket::stream_base::decorator([&protocol](websocket::response_type& answer) {
        answer.set(beast::http::field::sec_websocket_protocol, protocol.name);
      }));
  stream_.read_message_max(connections_->options.max_message_bytes);
  stream_.auto_fragment(false);
  stream_.async_accept(request, [self = shared_from_this(), &protocol](beast::error_code error) {
    if (error) return;
    self->conversation_ = protocol.begin(self.get());
    self->Read();
  });
}

void WebSocketSession::Read() {
  stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    // Garbage, too long a message, a closed connection: all the same.
    if (!error) self->OnMessage();
  });
}

void WebSocketSession::OnMessage() {
  const auto bytes = buffer_.data();
  const std::string_view data(static_cast<const char*>(bytes.data()), bytes.size());
  try {
    conversation_->OnMessage(data, stream_.got_binary());
  } catch (const std::exception& error) {
    VLOG(1) << "a client of the view: " << error.what();
    return Close();
  }
  buffer_.consume(buffer_.size());
  Read();
}

void WebSocketSession::Send(MessagePtr message) {
  if (is_closing_) return;
  waiting_bytes_ += message->data.size();
  waiting_.push_back(std::move(message));
  if (waiting_.size() == 1) Write();
}

void WebSocketSession::Write() {
  stream_.binary(waiting_.front()->is_binary);
  stream_.async_write(boost::asio::buffer(waiting_.front()->data),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        if (error) {
                          self->is_closing_ = true;  // what waits is never sent
                          return;
                        }
                        self->OnWritten();
                      });
}

void WebSocketSession::OnWritten() {
  waiting_bytes_ -= waiting_.front()->data.size();
  waiting_.pop_front();
  if (!waiting_.empty()) return Write();
  if (conversation_) conversation_->OnDrained();
}

void WebSocketSession::Close() {
  if (is_closing_) return;
  is_closing_ = true;
  stream_.async_close(websocket::close_code::going_away,
                      [self = shared_from_this()](beast::error_code) {});
}

void BeginWebSocketSession(boost::asio::ip::tcp::socket socket, const HttpRequest& request,
                           const Protocol& protocol,
                           const std::shared_ptr<Connections>& connections) {
  std::make_shared<WebSocketSession>(std::move(socket), connections)->Accept(request, protocol);
}

}  // namespace gmapping_spa::view
