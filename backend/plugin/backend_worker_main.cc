// SPDX-License-Identifier: BSD-3-Clause
// gmapping_spa_backend_worker: the process of a back end, started by ProcessOptimizer. It loads the
// plugin, says whether that went well, and answers requests until its channel is closed.
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include "backend/plugin/optimizer_packets.h"
#include "backend/plugin/packet_channel.h"
#include "backend/plugin/plugin_loader.h"

namespace gmapping_spa::backend {
namespace {

constexpr auto kNever = PacketChannel::TimePoint::max();

// A program that ends, however it ends, leaves no back end behind, even one that hangs.
void EndWithTheProgram(int socket) {
  std::thread([socket] {
    pollfd what{socket, 0, 0};
    while (poll(&what, 1, -1) <= 0) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // for one that ends by itself
    _exit(0);
  }).detach();
}

// Calls what may throw, and replies with what it says.
template <typename Function>
OptimizerReply Answer(const Function& function) {
  OptimizerReply reply;
  try {
    reply.summary = function();
    return reply;
  } catch (const std::exception& error) {
    reply.summary.message = error.what();
  } catch (...) {
    reply.summary.message = "an exception of unknown type";
  }
  reply.threw = true;
  return reply;
}

void AnswerRequests(const std::string& plugin, const PacketChannel& channel) {
  std::unique_ptr<Optimizer> optimizer;
  const OptimizerReply loaded = Answer([&] {
    optimizer = LoadOptimizer(plugin);
    return Summary();
  });
  channel.Send(PackReply(loaded, {}), kNever);
  while (optimizer != nullptr) {
    OptimizerRequest request =
        UnpackRequest(channel.Receive(std::numeric_limits<std::size_t>::max(), kNever));
    const OptimizerReply reply = Answer([&] {
      if (request.kind == OptimizerRequest::Kind::kCheckOptions) {
        optimizer->CheckOptions(request.options);
        return Summary();
      }
      return optimizer->Optimize(request.options, request.edges, request.nodes);
    });
    channel.Send(PackReply(reply, request.nodes), kNever);
  }
}

}  // namespace
}  // namespace gmapping_spa::backend

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "gmapping_spa_backend_worker is started by programs, not by hand.\n");
    return 1;
  }
  const int socket = std::atoi(argv[2]);
  gmapping_spa::backend::EndWithTheProgram(socket);
  const gmapping_spa::backend::PacketChannel channel(socket);
  try {
    gmapping_spa::backend::AnswerRequests(argv[1], channel);
  } catch (const gmapping_spa::backend::ChannelClosed&) {
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gmapping_spa_backend_worker: %s\n", error.what());
    return 1;
  }
  return 0;
}
