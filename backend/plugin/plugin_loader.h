// SPDX-License-Identifier: BSD-3-Clause
// Finds and loads back ends.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_LOADER_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_LOADER_H_

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backend/plugin/optimizer.h"
#include "backend/plugin/settings.h"

namespace gmapping_spa::backend {

// The folders that are searched for plugins, first to last: those of the environment's
// GMAPPING_SPA_PLUGIN_PATH (separated by colons), the one that belongs to the running executable
// (in a build tree or an install tree), the one of the package that it was linked with by
// find_package(gmapping_spa), the one that was configured for installation.
std::vector<std::string> PluginSearchPath();

// The path of the back end `name`: the first libgmapping_spa_<name>.so in `folders`; a name with a
// '/' in it is a path. Throws std::runtime_error with one line when there is none.
std::string FindPlugin(const std::string& name, const std::vector<std::string>& folders);

// Makes the optimizer of that back end. Throws std::runtime_error with one line when there
// is none, when it is no plugin, has another ABI version or cannot make an optimizer.
// What the plugin's optimizer throws becomes a failed Summary. Plugins stay loaded until the
// process ends.
std::unique_ptr<Optimizer> LoadOptimizer(const std::string& name,
                                         const std::vector<std::string>& folders);
std::unique_ptr<Optimizer> LoadOptimizer(const std::string& name);

struct BackendDescription {
  std::string name;
  std::string path;
  std::string description;  // of a plugin that cannot be loaded: why
  bool loadable = false;
  bool has_covariances = false;
  std::string losses;                            // that it supports, separated by commas
  std::span<const SettingDescription> settings;  // there until the process ends
};

// All back ends in `folders`, by name; of several with the same name, the one that LoadOptimizer
// takes.
std::vector<BackendDescription> ListBackends(const std::vector<std::string>& folders);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_LOADER_H_
