// SPDX-License-Identifier: BSD-3-Clause
// Back ends that break one rule each, chosen by a macro: what a loader has to live with.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "backend/plugin/plugin.h"

namespace gmapping_spa::backend {
namespace {

class Misbehaving : public Optimizer {
 public:
  Misbehaving() {
#if defined(THROWING_FACTORY)
    throw std::runtime_error("no licence found");
#elif defined(CRASHING_FACTORY)
    std::abort();
#endif
  }
  Summary Optimize(const Options&, std::span<const Edge>, std::span<Node> nodes) override {
#if defined(THROWING)
    throw std::runtime_error("out of cheese");
#elif defined(HANGING)
    // A test may want to know when.
    if (const char* sign = std::getenv("GMAPPING_SPA_TEST_HANGS")) std::ofstream{sign};
    for (;;) pause();
#elif defined(CRASHING)
    std::signal(SIGSEGV, SIG_DFL);  // not that of a sanitizer
    std::raise(SIGSEGV);
#elif defined(EXITING)
    std::exit(3);
#elif defined(BABBLING)
    for (int descriptor = 3; descriptor < 10; ++descriptor) {
      if (write(descriptor, "no packet at all, whatever it is", 32) < 0) continue;
    }
#endif
    for (Node& node : nodes) node.world_T_node.x = std::numeric_limits<double>::quiet_NaN();
    Summary summary;
    summary.termination = Termination::kConverged;
    return summary;
  }
};

}  // namespace
}  // namespace gmapping_spa::backend

using gmapping_spa::backend::Misbehaving;

#if defined(WRONG_ABI)
extern "C" const GmappingSpaPlugin* gmapping_spa_backend_plugin() {
  static const GmappingSpaPlugin table = {
      GMAPPING_SPA_PLUGIN_ABI_VERSION + 1, "wrong", "", nullptr, 0, 0, nullptr, nullptr, nullptr};
  return &table;
}
#elif defined(THROWING_ENTRY_POINT)
extern "C" const GmappingSpaPlugin* gmapping_spa_backend_plugin() { throw 42; }
#elif !defined(WITHOUT_ENTRY_POINT)
GMAPPING_SPA_BACKEND_PLUGIN(Misbehaving, "misbehaving", "breaks one rule");
#endif
