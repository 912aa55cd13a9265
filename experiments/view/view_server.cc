// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/view_server.h"

#include <glog/logging.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <exception>
#include <future>
#include <stdexcept>
#include <thread>
#include <utility>

#include "experiments/view/connections.h"
#include "experiments/view/http_session.h"
#include "experiments/view/web_socket_session.h"

namespace gmapping_spa::view {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr auto kRest = std::chrono::milliseconds(100);

}  // namespace

class ViewServer::Implementation {
 public:
  Implementation(const ServerOptions& options, std::vector<StaticFile> files,
                 std::vector<Protocol> protocols)
      : connections_(
            std::make_shared<Connections>(options, std::move(files), std::move(protocols))),
        acceptor_(context_),
        rest_(context_) {
    Listen(options);
    Accept();
    thread_ = std::thread([this] { Run(); });
  }

  ~Implementation() {
    // Those that are open are closed in a civil way, and what does not end by that is dropped.
    asio::post(context_, [this] {
      acceptor_.close();
      rest_.cancel();
      for (WebSocketSession* session : connections_->sessions) session->Close();
    });
    const auto end = std::chrono::steady_clock::now() + 5 * kRest;
    while (connections_->clients > 0 && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(kRest / 20);
    }
    context_.stop();
    thread_.join();
  }

  std::uint16_t port() const { return port_; }
  int CountClients() const { return connections_->clients; }
  void Post(std::function<void()> work) { asio::post(context_, std::move(work)); }

  bool HaveSentAll() {
    std::promise<bool> sent;
    Post([&] {
      bool all = true;
      for (const WebSocketSession* session : connections_->sessions) {
        all = all && session->HasSentAll();
      }
      sent.set_value(all);
    });
    return sent.get_future().get();
  }

 private:
  void Listen(const ServerOptions& options) {
    boost::system::error_code error;
    const asio::ip::address address = asio::ip::make_address(options.address, error);
    if (error) {
      throw std::runtime_error("expected an address of this machine in numbers, found '" +
                               options.address + "'");
    }
    const tcp::endpoint endpoint(address, options.port);
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) {
      throw std::runtime_error("cannot listen at port " + std::to_string(options.port) + " of " +
                               options.address + ": " + error.message());
    }
    port_ = acceptor_.local_endpoint().port();
  }

  void Accept() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return AcceptAfterARest();  // out of file descriptors, perhaps
      // Else it is closed here.
      if (connections_->connections < connections_->options.max_connections) {
        BeginHttpSession(std::move(socket), connections_);
      }
      Accept();
    });
  }

  void AcceptAfterARest() {
    rest_.expires_after(kRest);
    rest_.async_wait([this](boost::system::error_code error) {
      if (!error) Accept();
    });
  }

  // Whatever goes wrong here must not end the run that is looked at.
  void Run() {
    while (!context_.stopped()) {
      try {
        context_.run();
      } catch (const std::exception& error) {
        LOG(WARNING) << "the view goes on after an error: " << error.what();
      }
    }
  }

  std::shared_ptr<Connections> connections_;  // outlives what the context still holds
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  asio::steady_timer rest_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

ViewServer::ViewServer(const ServerOptions& options, std::vector<StaticFile> files,
                       std::vector<Protocol> protocols)
    : implementation_(
          std::make_unique<Implementation>(options, std::move(files), std::move(protocols))) {}

ViewServer::~ViewServer() = default;

std::uint16_t ViewServer::port() const { return implementation_->port(); }

int ViewServer::CountClients() const { return implementation_->CountClients(); }

void ViewServer::Post(std::function<void()> work) { implementation_->Post(std::move(work)); }

void ViewServer::Drain(std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!implementation_->HaveSentAll() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kRest / 10);
  }
}

}  // namespace gmapping_spa::view
