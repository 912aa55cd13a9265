// What crosses the boundary between this software and a back end in a shared library: plain data
// and plain functions, so that the two may come from different compilers and settings. Authors of
// back ends use plugin.h instead.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_ABI_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_ABI_H_

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "backend/graph/pose_graph.h"
#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// Raised with every change of the types below.
inline constexpr std::uint32_t kPluginAbiVersion = 1;

// The one symbol of a plugin: a function without arguments that returns a `const PluginTable*`.
inline constexpr char kPluginEntryPoint[] = "gmapping_spa_backend_plugin";

static_assert(std::is_standard_layout_v<Node> && sizeof(Node) == 48);
static_assert(std::is_standard_layout_v<Edge> && sizeof(Edge) == 120);
static_assert(std::is_standard_layout_v<Loss> && sizeof(Loss) == 24);
static_assert(std::is_standard_layout_v<IterationRecord> && sizeof(IterationRecord) == 40);

struct PluginSetting {
  const char* name;
  const char* value;
};

// backend::Options.
struct PluginOptions {
  std::int32_t max_iterations;
  Initialization initialization;
  double cost_tolerance;
  Loss loss;
  const PluginSetting* settings;
  std::size_t setting_count;
};

struct PluginGraph {
  Node* nodes;
  std::size_t node_count;
  const Edge* edges;
  std::size_t edge_count;
};

// Where a plugin puts its backend::Summary. The functions take `context` as it is.
struct PluginReport {
  void* context;
  void (*set_outcome)(void* context, Termination termination, const char* message,
                      double initial_cost, double final_cost);
  void (*add_iteration)(void* context, const IterationRecord* record);
};

struct PluginTable {
  std::uint32_t abi_version;  // kPluginAbiVersion; stays the first member for ever
  const char* name;
  const char* description;  // one line, with the names of the settings
  // Makes an optimizer; on failure reports it and returns null.
  void* (*create)(const PluginReport* report);
  void (*destroy)(void* optimizer);
  void (*optimize)(void* optimizer, const PluginOptions* options, const PluginGraph* graph,
                   const PluginReport* report);
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_ABI_H_
