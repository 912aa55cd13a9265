// SPDX-License-Identifier: BSD-3-Clause
// For authors of back ends: makes a plugin of a backend::Optimizer. plugins/README.md tells how.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_H_

#include <array>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "backend/plugin/abi_conversion.h"
#include "backend/plugin/plugin_abi.h"
#include "backend/plugin/settings.h"

namespace gmapping_spa::backend {

// The functions of the table of a plugin whose optimizer is an OptimizerType, which has a
// constructor without arguments. No exception leaves them.
template <typename OptimizerType>
class PluginAdapter {
 public:
  static GmappingSpaPlugin Table(const char* name, const char* description) {
    GmappingSpaPlugin table{};
    table.abi_version = GMAPPING_SPA_PLUGIN_ABI_VERSION;
    table.name = name;
    table.description = description;
    if constexpr (requires { OptimizerType::kSettings; }) {
      const std::span<const SettingDescription> settings = OptimizerType::kSettings;
      table.settings = settings.data();
      table.setting_count = settings.size();
    }
    table.losses = LossBit(LossKind::kNone);
    if constexpr (requires { OptimizerType::kLosses; }) {
      for (const LossKind kind : OptimizerType::kLosses) table.losses |= LossBit(kind);
    }
    table.create = &Create;
    table.destroy = &Destroy;
    table.optimize = &Optimize;
    return table;
  }

  // For GMAPPING_SPA_BACKEND_COVARIANCES.
  static void Covariances(void* optimizer, const GmappingSpaGraph* graph,
                          const GmappingSpaNodePair* pairs, std::size_t pair_count,
                          double* covariances, const GmappingSpaReport* report) noexcept {
    try {
      const std::vector<Eigen::Matrix3d> blocks =
          static_cast<PluginAdapter*>(optimizer)->optimizer_.Covariances(
              EdgesOf(*graph), NodesOf(*graph),
              {reinterpret_cast<const EdgeNodes*>(pairs), pair_count});
      for (std::size_t k = 0; k < pair_count; ++k) {
        Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(covariances + 9 * k) =
            blocks.at(k);
      }
      report->set_outcome(report->context, GMAPPING_SPA_CONVERGED, "", 0.0, 0.0);
    } catch (const std::exception& error) {
      Fail(error.what(), *report);
    } catch (...) {
      Fail("an exception of unknown type", *report);
    }
  }

  // For GMAPPING_SPA_BACKEND_STATE.
  static void SaveState(void* optimizer, void* context,
                        void (*take)(void* context, const char* bytes, std::size_t size),
                        const GmappingSpaReport* report) noexcept {
    try {
      const std::string state = static_cast<PluginAdapter*>(optimizer)->optimizer_.State().value();
      take(context, state.data(), state.size());
      report->set_outcome(report->context, GMAPPING_SPA_CONVERGED, "", 0.0, 0.0);
    } catch (const std::exception& error) {
      Fail(error.what(), *report);
    } catch (...) {
      Fail("an exception of unknown type", *report);
    }
  }
  static void RestoreState(void* optimizer, const char* bytes, std::size_t size,
                           const GmappingSpaReport* report) noexcept {
    try {
      static_cast<PluginAdapter*>(optimizer)->optimizer_.SetState({bytes, size});
      report->set_outcome(report->context, GMAPPING_SPA_CONVERGED, "", 0.0, 0.0);
    } catch (const std::exception& error) {
      Fail(error.what(), *report);
    } catch (...) {
      Fail("an exception of unknown type", *report);
    }
  }

 private:
  static void* Create(const GmappingSpaReport* report) noexcept {
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

  static void Optimize(void* optimizer, const GmappingSpaOptions* options,
                       const GmappingSpaGraph* graph, const GmappingSpaReport* report) noexcept {
    try {
      const Summary summary = static_cast<PluginAdapter*>(optimizer)->optimizer_.Optimize(
          FromAbi(*options), EdgesOf(*graph), NodesOf(*graph));
      for (const IterationRecord& record : summary.iterations) {
        const GmappingSpaIteration iteration = ToAbi(record);
        report->add_iteration(report->context, &iteration);
      }
      report->set_outcome(report->context, static_cast<std::int32_t>(summary.termination),
                          summary.message.c_str(), summary.initial_cost, summary.final_cost);
    } catch (const std::bad_alloc&) {
      std::array<char, 100> message{};  // asks for no memory
      std::snprintf(message.data(), message.size(), "out of memory for %zu nodes and %zu edges",
                    graph->node_count, graph->edge_count);
      Fail(message.data(), *report);
    } catch (const std::exception& error) {
      Fail(error.what(), *report);
    } catch (...) {
      Fail("an exception of unknown type", *report);
    }
  }

  static void Fail(const char* message, const GmappingSpaReport& report) {
    report.set_outcome(report.context, GMAPPING_SPA_FAILURE, message, 0.0, 0.0);
  }

  OptimizerType optimizer_;
};

}  // namespace gmapping_spa::backend

// Defines the entry point of a plugin. Use it once, outside any namespace. OptimizerType may have
//   static constexpr SettingDescription kSettings[]   its settings; none without it
//   static constexpr LossKind kLosses[]   the robust losses that it supports; without it, least
//                                         squares only
#define GMAPPING_SPA_BACKEND_PLUGIN(OptimizerType, name, description)                  \
  extern "C" __attribute__((visibility("default"))) const GmappingSpaPlugin*           \
  gmapping_spa_backend_plugin() {                                                      \
    static const GmappingSpaPlugin table =                                             \
        gmapping_spa::backend::PluginAdapter<OptimizerType>::Table(name, description); \
    return &table;                                                                     \
  }                                                                                    \
  static_assert(true, "a semicolon follows")

// Beside it, for an OptimizerType that overrides HasCovariances and Covariances: without this
// line, the plugin has not the ability.
#define GMAPPING_SPA_BACKEND_COVARIANCES(OptimizerType)                                    \
  extern "C" __attribute__((visibility("default"))) void gmapping_spa_backend_covariances( \
      void* optimizer, const GmappingSpaGraph* graph, const GmappingSpaNodePair* pairs,    \
      std::size_t pair_count, double* covariances, const GmappingSpaReport* report) {      \
    gmapping_spa::backend::PluginAdapter<OptimizerType>::Covariances(                      \
        optimizer, graph, pairs, pair_count, covariances, report);                         \
  }                                                                                        \
  static_assert(true, "a semicolon follows")

// Likewise for an OptimizerType that overrides State and SetState.
#define GMAPPING_SPA_BACKEND_STATE(OptimizerType)                                    \
  extern "C" __attribute__((visibility("default"))) const GmappingSpaStateFunctions* \
  gmapping_spa_backend_state() {                                                     \
    using Adapter = gmapping_spa::backend::PluginAdapter<OptimizerType>;             \
    static const GmappingSpaStateFunctions functions = {&Adapter::SaveState,         \
                                                        &Adapter::RestoreState};     \
    return &functions;                                                               \
  }                                                                                  \
  static_assert(true, "a semicolon follows")

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_H_
