// For authors of back ends: makes a plugin of a backend::Optimizer. plugins/README.md tells how.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_H_

#include <exception>
#include <memory>

#include "backend/plugin/plugin_abi.h"

namespace gmapping_spa::backend {

// The functions of the table of a plugin whose optimizer is an OptimizerType, which has a
// constructor without arguments. No exception leaves them.
template <typename OptimizerType>
class PluginAdapter {
 public:
  static void* Create(const PluginReport* report) noexcept {
    try {
      return new PluginAdapter();
    } catch (const std::exception& error) {
      Fail(error.what(), *report);
    } catch (...) {
      Fail("an exception of unknown type", *report);
    }
    return nullptr;
  }

  static void Destroy(void* optimizer) noexcept { delete static_cast<PluginAdapter*>(optimizer); }

  static void Optimize(void* optimizer, const PluginOptions* options, const PluginGraph* graph,
                       const PluginReport* report) noexcept {
    try {
      static_cast<PluginAdapter*>(optimizer)->OptimizeOrThrow(*options, *graph, *report);
    } catch (const std::exception& error) {
      Fail(error.what(), *report);
    } catch (...) {
      Fail("an exception of unknown type", *report);
    }
  }

 private:
  static void Fail(const char* message, const PluginReport& report) {
    report.set_outcome(report.context, Termination::kFailure, message, 0.0, 0.0);
  }

  void OptimizeOrThrow(const PluginOptions& plain_options, const PluginGraph& plain_graph,
                       const PluginReport& report) {
    Options options;
    options.max_iterations = plain_options.max_iterations;
    options.initialization = plain_options.initialization;
    options.cost_tolerance = plain_options.cost_tolerance;
    options.loss = plain_options.loss;
    for (std::size_t k = 0; k < plain_options.setting_count; ++k) {
      options.settings[plain_options.settings[k].name] = plain_options.settings[k].value;
    }
    const Summary summary =
        optimizer_.Optimize(options, {plain_graph.edges, plain_graph.edge_count},
                            {plain_graph.nodes, plain_graph.node_count});
    for (const IterationRecord& record : summary.iterations) {
      report.add_iteration(report.context, &record);
    }
    report.set_outcome(report.context, summary.termination, summary.message.c_str(),
                       summary.initial_cost, summary.final_cost);
  }

  OptimizerType optimizer_;
};

}  // namespace gmapping_spa::backend

// Defines the entry point of a plugin. Use it once, outside any namespace.
#define GMAPPING_SPA_BACKEND_PLUGIN(OptimizerType, name, description)                         \
  extern "C" __attribute__((visibility("default"))) const gmapping_spa::backend::PluginTable* \
  gmapping_spa_backend_plugin() {                                                             \
    using Adapter = gmapping_spa::backend::PluginAdapter<OptimizerType>;                      \
    static const gmapping_spa::backend::PluginTable table = {                                 \
        gmapping_spa::backend::kPluginAbiVersion,                                             \
        name,                                                                                 \
        description,                                                                          \
        &Adapter::Create,                                                                     \
        &Adapter::Destroy,                                                                    \
        &Adapter::Optimize};                                                                  \
    return &table;                                                                            \
  }                                                                                           \
  static_assert(true, "a semicolon follows")

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_H_
