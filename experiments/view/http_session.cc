// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/http_session.h"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "experiments/view/http_answer.h"
#include "experiments/view/web_socket_session.h"

namespace gmapping_spa::view {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

constexpr auto kPatience = std::chrono::seconds(30);
constexpr std::uint32_t kMaxHeaderBytes = 8192;
constexpr std::uint64_t kMaxBodyBytes = 1024;  // nobody has anything to send

class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket, std::shared_ptr<Connections> connections)
      : stream_(std::move(socket)), connections_(std::move(connections)) {
    ++connections_->connections;
  }
  ~HttpSession() { --connections_->connections; }
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void Read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeaderBytes);
    parser_->body_limit(kMaxBodyBytes);
    stream_.expires_after(kPatience);
    http::async_read(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](beast::error_code error, std::size_t) { self->OnRead(error); });
  }

 private:
  void OnRead(beast::error_code error) {
    if (error == http::error::end_of_stream) return Close();
    // A client that has gone or takes too long gets no answer; one that writes nonsense does.
    if (error && error.category() != http::make_error_code(http::error::bad_method).category()) {
      return;
    }
    if (error) return Write(PlainAnswer(http::status::bad_request, 11, false, "no HTTP\n"));
    const HttpRequest request = parser_->release();
    const std::optional<HttpAnswer> refusal = Refusal(request, *connections_);
    if (refusal) return Write(*refusal);
    if (!beast::websocket::is_upgrade(request)) {
      return Write(FileAnswer(request, connections_->files));
    }
    std::variant<const Protocol*, HttpAnswer> choice = ChooseProtocol(request, *connections_);
    if (const auto* answer = std::get_if<HttpAnswer>(&choice)) return Write(*answer);
    stream_.expires_never();  // WebSockets have a clock of their own
    BeginWebSocketSession(stream_.release_socket(), request, *std::get<const Protocol*>(choice),
                          connections_);
  }

  void Write(HttpAnswer answer) {
    answer_ = std::move(answer);
    stream_.expires_after(kPatience);
    http::async_write(stream_, answer_,
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        if (error) return;
                        if (self->answer_.need_eof()) return self->Close();
                        self->Read();
                      });
  }

  void Close() {
    beast::error_code ignored;  // it may have gone
    stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  std::shared_ptr<Connections> connections_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  HttpAnswer answer_;
};

}  // namespace

void BeginHttpSession(boost::asio::ip::tcp::socket socket,
                      const std::shared_ptr<Connections>& connections) {
  std::make_shared<HttpSession>(std::move(socket), connections)->Read();
}

}  // namespace gmapping_spa::view
