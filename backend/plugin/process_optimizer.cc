// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/process_optimizer.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "backend/packet.h"
#include "backend/plugin/optimizer_packets.h"
#include "backend/plugin/packet_channel.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/plugin/worker_process.h"

namespace gmapping_spa::backend {
namespace {

constexpr char kWorker[] = "gmapping_spa_backend_worker";

// Beside the plugins.
std::string FindWorker() {
  std::string searched;
  for (const std::string& folder : PluginSearchPath()) {
    const std::filesystem::path path = std::filesystem::path(folder) / kWorker;
    if (std::error_code error; std::filesystem::is_regular_file(path, error)) return path.string();
    searched += (searched.empty() ? "" : ":") + folder;
  }
  throw std::runtime_error(std::string("there is no ") + kWorker + " in " + searched);
}

struct BackendDied : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Options WithTimeout(double timeout_s) {
  Options options;
  options.max_solver_time_s = timeout_s;
  return options;
}

}  // namespace

ProcessOptimizer::ProcessOptimizer(const std::string& name, double timeout_s)
    : plugin_(FindPlugin(name, PluginSearchPath())), worker_(FindWorker()), timeout_s_(timeout_s) {
  if (!(timeout_s > 0.0)) throw std::runtime_error("the timeout of a back end must be above 0 s");
  Watch([&] { Start(DeadlineOf(WithTimeout(timeout_s_))); });
}

ProcessOptimizer::~ProcessOptimizer() = default;

template <typename Function>
void ProcessOptimizer::Watch(const Function& function) const {
  std::ostringstream failure;
  try {
    function();
    return;
  } catch (const ChannelTimeout&) {
    process_->Kill();
    failure << "the back end took longer than " << timeout_s_ << " s and was stopped";
  } catch (const ChannelClosed&) {
    failure << "the back end " << process_->End();
  } catch (const MalformedPacket&) {
    process_->Kill();
    failure << "the process of the back end answered with what is no result, and was stopped";
  }
  process_.reset();
  throw BackendDied(failure.str());
}

void ProcessOptimizer::Start(std::chrono::steady_clock::time_point deadline) const {
  process_ = std::make_unique<WorkerProcess>(worker_, plugin_);
  // The first packet tells whether the plugin could be loaded.
  const OptimizerReply loaded =
      UnpackReply(process_->channel().Receive(LargestReply(0), deadline), {});
  if (!loaded.threw) return;
  process_.reset();
  throw std::runtime_error(loaded.summary.message);
}

Summary ProcessOptimizer::Call(const std::vector<char>& request, std::span<Node> nodes) const {
  OptimizerReply reply;
  Watch([&] {
    const auto deadline = DeadlineOf(WithTimeout(timeout_s_));
    if (process_ == nullptr) Start(deadline);
    process_->channel().Send(request, deadline);
    reply = UnpackReply(process_->channel().Receive(LargestReply(nodes.size()), deadline), nodes);
  });
  if (reply.threw) throw std::runtime_error(reply.summary.message);
  return reply.summary;
}

void ProcessOptimizer::CheckOptions(const Options& options) const {
  Call(PackRequest(OptimizerRequest::Kind::kCheckOptions, options, {}, {}), {});
}

Summary ProcessOptimizer::Optimize(const Options& options, std::span<const Edge> edges,
                                   std::span<Node> nodes) {
  std::vector<Node> optimized(nodes.begin(), nodes.end());
  try {
    Summary summary =
        Call(PackRequest(OptimizerRequest::Kind::kOptimize, options, edges, nodes), optimized);
    std::copy(optimized.begin(), optimized.end(), nodes.begin());
    return summary;
  } catch (const BackendDied& died) {
    Summary failure;
    failure.message = died.what();
    return failure;
  }
}

}  // namespace gmapping_spa::backend
