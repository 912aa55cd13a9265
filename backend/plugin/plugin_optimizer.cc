// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/plugin_optimizer.h"

#include <stdexcept>
#include <vector>

#include "backend/plugin/abi_conversion.h"

namespace gmapping_spa::backend {
namespace {

constexpr LossKind kAllLosses[] = {LossKind::kNone, LossKind::kHuber, LossKind::kCauchy,
                                   LossKind::kDcs, LossKind::kTruncated};

Termination TerminationOf(std::int32_t termination) {
  switch (termination) {
    case GMAPPING_SPA_CONVERGED:
      return Termination::kConverged;
    case GMAPPING_SPA_NO_CONVERGENCE:
      return Termination::kNoConvergence;
    default:
      return Termination::kFailure;
  }
}

GmappingSpaReport ReportInto(Summary* summary) {
  GmappingSpaReport report{};
  report.context = summary;
  report.set_outcome = [](void* context, std::int32_t termination, const char* message,
                          double initial_cost, double final_cost) {
    Summary& to = *static_cast<Summary*>(context);
    to.termination = TerminationOf(termination);
    to.message = message == nullptr ? "" : message;
    to.initial_cost = initial_cost;
    to.final_cost = final_cost;
  };
  report.add_iteration = [](void* context, const GmappingSpaIteration* iteration) {
    static_cast<Summary*>(context)->iterations.push_back(FromAbi(*iteration));
  };
  return report;
}

// After a call of an ability.
void ThrowUnlessDone(const Summary& summary) {
  if (summary.termination != Termination::kConverged) throw std::runtime_error(summary.message);
}

}  // namespace

std::span<const SettingDescription> SettingsOf(const GmappingSpaPlugin& plugin) {
  return {plugin.settings, plugin.setting_count};
}

std::string LossesOf(const GmappingSpaPlugin& plugin) {
  std::string names;
  for (const LossKind kind : kAllLosses) {
    if ((plugin.losses & LossBit(kind)) == 0) continue;
    names += (names.empty() ? "" : ", ") + std::string(LossKindName(kind));
  }
  return names;
}

PluginOptimizer::PluginOptimizer(const std::string& path, const GmappingSpaPlugin& plugin,
                                 GmappingSpaCovariancesFunction covariances,
                                 const GmappingSpaStateFunctions* state)
    : plugin_(plugin), covariances_(covariances), state_(state) {
  Summary summary;
  const GmappingSpaReport report = ReportInto(&summary);
  try {
    optimizer_ = plugin_.create(&report);
  } catch (const std::exception& error) {
    summary.message = error.what();
  } catch (...) {
    summary.message = "an exception of unknown type";
  }
  if (optimizer_ == nullptr) {
    throw std::runtime_error("the back end " + path +
                             " cannot make an optimizer: " + summary.message);
  }
}

PluginOptimizer::~PluginOptimizer() {
  try {
    plugin_.destroy(optimizer_);
  } catch (...) {
    // Nobody is left to be told.
  }
}

void PluginOptimizer::CheckOptions(const Options& options) const {
  const std::string name = plugin_.name;
  try {
    Settings(SettingsOf(plugin_), options.settings);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("back end " + name + ": " + error.what());
  }
  if ((plugin_.losses & LossBit(options.loss.kind)) == 0) {
    throw std::runtime_error("back end " + name + ": expected a loss out of " + LossesOf(plugin_) +
                             ", got '" + LossKindName(options.loss.kind) + "'");
  }
}

Summary PluginOptimizer::Optimize(const Options& options, std::span<const Edge> edges,
                                  std::span<Node> nodes) {
  std::vector<GmappingSpaSetting> settings;
  for (const auto& [name, value] : options.settings) {
    settings.push_back({name.c_str(), value.c_str()});
  }
  GmappingSpaOptions plain = ToAbi(options);
  plain.settings = settings.data();
  plain.setting_count = settings.size();
  const GmappingSpaGraph graph = ToAbi(edges, nodes);
  Summary summary;
  const GmappingSpaReport report = ReportInto(&summary);
  plugin_.optimize(optimizer_, &plain, &graph, &report);
  return summary;
}

std::vector<Eigen::Matrix3d> PluginOptimizer::Covariances(std::span<const Edge> edges,
                                                          std::span<const Node> nodes,
                                                          std::span<const EdgeNodes> pairs) {
  if (covariances_ == nullptr) return Optimizer::Covariances(edges, nodes, pairs);
  std::vector<Node> lent(nodes.begin(), nodes.end());  // plain C has no graph to read only
  const GmappingSpaGraph graph = ToAbi(edges, lent);
  std::vector<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> blocks(pairs.size());
  Summary summary;
  const GmappingSpaReport report = ReportInto(&summary);
  covariances_(optimizer_, &graph, reinterpret_cast<const GmappingSpaNodePair*>(pairs.data()),
               pairs.size(), reinterpret_cast<double*>(blocks.data()), &report);
  ThrowUnlessDone(summary);
  return {blocks.begin(), blocks.end()};
}

std::optional<std::string> PluginOptimizer::State() const {
  if (state_ == nullptr) return std::nullopt;
  std::string bytes;
  Summary summary;
  const GmappingSpaReport report = ReportInto(&summary);
  const auto take = [](void* context, const char* data, std::size_t size) {
    static_cast<std::string*>(context)->assign(data, size);
  };
  state_->save(optimizer_, &bytes, take, &report);
  ThrowUnlessDone(summary);
  return bytes;
}

void PluginOptimizer::SetState(const std::string& state) {
  if (state_ == nullptr) return Optimizer::SetState(state);
  Summary summary;
  const GmappingSpaReport report = ReportInto(&summary);
  state_->restore(optimizer_, state.data(), state.size(), &report);
  ThrowUnlessDone(summary);
}

}  // namespace gmapping_spa::backend
