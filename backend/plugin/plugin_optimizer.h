// SPDX-License-Identifier: BSD-3-Clause
// An optimizer on the other side of a plugin's boundary.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_OPTIMIZER_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_OPTIMIZER_H_

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "backend/plugin/optimizer.h"
#include "backend/plugin/plugin_abi.h"
#include "backend/plugin/settings.h"

namespace gmapping_spa::backend {

std::span<const SettingDescription> SettingsOf(const GmappingSpaPlugin& plugin);

// Names of the losses that the plugin supports, separated by commas.
std::string LossesOf(const GmappingSpaPlugin& plugin);

// Lets no exception of the plugin out of its constructor and destructor; those of Optimize are the
// caller's (OptimizeSafely). Plugins made with plugin.h throw none.
class PluginOptimizer : public Optimizer {
 public:
  // `plugin` must outlive the object; `path` is for messages; `covariances` and `state` are null
  // for a plugin that has not the ability. Throws std::runtime_error with one line when the plugin
  // makes no optimizer.
  PluginOptimizer(const std::string& path, const GmappingSpaPlugin& plugin,
                  GmappingSpaCovariancesFunction covariances,
                  const GmappingSpaStateFunctions* state);
  ~PluginOptimizer() override;
  PluginOptimizer(const PluginOptimizer&) = delete;
  PluginOptimizer& operator=(const PluginOptimizer&) = delete;

  void CheckOptions(const Options& options) const override;
  Summary Optimize(const Options& options, std::span<const Edge> edges,
                   std::span<Node> nodes) override;
  bool HasCovariances() const override { return covariances_ != nullptr; }
  std::vector<Eigen::Matrix3d> Covariances(std::span<const Edge> edges, std::span<const Node> nodes,
                                           std::span<const EdgeNodes> pairs) override;
  std::optional<std::string> State() const override;
  void SetState(const std::string& state) override;

 private:
  const GmappingSpaPlugin& plugin_;
  GmappingSpaCovariancesFunction covariances_;
  const GmappingSpaStateFunctions* state_;
  void* optimizer_ = nullptr;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_OPTIMIZER_H_
