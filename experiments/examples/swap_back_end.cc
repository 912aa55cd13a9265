// SPDX-License-Identifier: BSD-3-Clause
// SLAM with a back end of one's own, part of the program: here one that asks spa, and tells of it.
#include <glog/logging.h>
#include <gmapping_spa/open_log.h>
#include <gmapping_spa/plugin_loader.h>
#include <gmapping_spa/slam.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace backend = gmapping_spa::backend;

class TalkingOptimizer : public backend::Optimizer {
 public:
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override {
    const backend::Summary summary = spa_->Optimize(options, edges, nodes);
    std::cout << nodes.size() << " nodes, " << edges.size() << " edges: the cost went from "
              << summary.initial_cost << " to " << summary.final_cost << '\n';
    return summary;
  }

 private:
  std::unique_ptr<backend::Optimizer> spa_ = backend::LoadOptimizer("spa");
};

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: swap_back_end LOG");
  FLAGS_logtostderr = true;  // what SLAM warns of goes through glog
  google::InitGoogleLogging(argv[0]);
  auto in = std::make_unique<std::ifstream>(argv[1]);
  if (!*in) throw std::runtime_error(std::string("cannot read ") + argv[1]);
  const auto log = gmapping_spa::sensor::OpenCarmenLog(std::move(in), argv[1], {});

  // One that is a plugin takes its name or path only: options.backend = "ceres".
  gmapping_spa::Slam slam({}, std::make_shared<TalkingOptimizer>());
  while (const auto scan = log->Next()) {
    const gmapping_spa::ScanResult result = slam.AddScan(*scan);
    if (result.closed_loop) std::cout << "loop closed at " << scan->stamp_s << " s\n";
  }
  slam.Finish();
  std::cout << slam.CurrentGraph().nodes.size() << " nodes in the end\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
