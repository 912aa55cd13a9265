// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/plugin_loader.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "backend/plugin/plugin_abi.h"
#include "backend/plugin/plugin_optimizer.h"

namespace gmapping_spa::backend {
namespace {

namespace fs = std::filesystem;

constexpr char kPrefix[] = "libgmapping_spa_";
constexpr char kSuffix[] = ".so";

struct Plugin {
  const GmappingSpaPlugin& table;
  // Null where it has not the ability.
  GmappingSpaCovariancesFunction covariances;
  const GmappingSpaStateFunctions* state;
};

// Opens the plugin and checks that the rest of its table is what this code takes it for.
Plugin OpenPlugin(const std::string& path) {
  const auto fail = [&](const std::string& why) {
    std::string message = "cannot load the back end " + path + ": " + why;
    std::replace(message.begin(), message.end(), '\n', ' ');
    throw std::runtime_error(message);
  };
  if (std::error_code error; !fs::is_regular_file(path, error)) fail("there is no such file");
  // Never closed: libraries that plugins bring along do not expect to be unloaded.
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) fail(dlerror());
  using EntryPoint = const GmappingSpaPlugin* (*)();
  const auto entry_point =
      reinterpret_cast<EntryPoint>(dlsym(library, GMAPPING_SPA_PLUGIN_ENTRY_POINT));
  if (entry_point == nullptr) {
    fail("it has no function " + std::string(GMAPPING_SPA_PLUGIN_ENTRY_POINT));
  }
  const GmappingSpaPlugin* table = nullptr;
  try {
    table = entry_point();
  } catch (...) {
    fail("its entry point threw an exception");
  }
  if (table == nullptr) fail("its entry point returned nothing");
  if (table->abi_version != GMAPPING_SPA_PLUGIN_ABI_VERSION) {
    fail("it has ABI version " + std::to_string(table->abi_version) + ", expected " +
         std::to_string(GMAPPING_SPA_PLUGIN_ABI_VERSION) + "; rebuild it");
  }
  if (table->name == nullptr || table->description == nullptr || table->create == nullptr ||
      table->destroy == nullptr || table->optimize == nullptr ||
      (table->settings == nullptr && table->setting_count > 0)) {
    fail("its table is incomplete");
  }
  using StateEntryPoint = const GmappingSpaStateFunctions* (*)();
  const auto state =
      reinterpret_cast<StateEntryPoint>(dlsym(library, GMAPPING_SPA_STATE_ENTRY_POINT));
  return {*table,
          reinterpret_cast<GmappingSpaCovariancesFunction>(
              dlsym(library, GMAPPING_SPA_COVARIANCES_ENTRY_POINT)),
          state == nullptr ? nullptr : state()};
}

// The folders for plugins along the library search path of the program or library that this code is
// linked into: find_package(gmapping_spa) puts that of the installed package there.
std::vector<std::string> PluginFoldersOfLibraryPath() {
  std::vector<std::string> folders;
  Dl_info info;
  void* self = nullptr;  // of type link_map*, which is a handle
  Dl_serinfo size;
  if (dladdr1(reinterpret_cast<const void*>(&PluginFoldersOfLibraryPath), &info, &self,
              RTLD_DL_LINKMAP) == 0 ||
      dlinfo(self, RTLD_DI_SERINFOSIZE, &size) != 0) {
    return folders;
  }
  std::vector<std::max_align_t> buffer(size.dls_size / sizeof(std::max_align_t) + 1);
  auto* const path = reinterpret_cast<Dl_serinfo*>(buffer.data());
  if (dlinfo(self, RTLD_DI_SERINFOSIZE, path) != 0 || dlinfo(self, RTLD_DI_SERINFO, path) != 0) {
    return folders;
  }
  const fs::path name = fs::path(GMAPPING_SPA_PLUGIN_FOLDER).filename();
  for (unsigned k = 0; k < path->dls_cnt; ++k) {
    const fs::path folder = path->dls_serpath[k].dls_name;
    if (folder.filename() == name) folders.push_back(folder.string());
  }
  return folders;
}

}  // namespace

std::vector<std::string> PluginSearchPath() {
  std::vector<std::string> folders;
  if (const char* const path = std::getenv("GMAPPING_SPA_PLUGIN_PATH"); path != nullptr) {
    std::istringstream parts(path);
    for (std::string folder; std::getline(parts, folder, ':');) {
      if (!folder.empty()) folders.push_back(folder);
    }
  }
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back(
        (executable.parent_path().parent_path() / GMAPPING_SPA_PLUGIN_FOLDER).string());
  }
  for (std::string& folder : PluginFoldersOfLibraryPath()) folders.push_back(std::move(folder));
  folders.emplace_back(GMAPPING_SPA_INSTALLED_PLUGIN_FOLDER);
  return folders;
}

std::string FindPlugin(const std::string& name, const std::vector<std::string>& folders) {
  if (name.find('/') != std::string::npos) return name;
  std::string searched;
  for (const std::string& folder : folders) {
    const fs::path path = fs::path(folder) / (kPrefix + name + kSuffix);
    if (std::error_code error; fs::is_regular_file(path, error)) return path.string();
    searched += (searched.empty() ? "" : ":") + folder;
  }
  throw std::runtime_error("there is no back end '" + name + "' (" + kPrefix + name + kSuffix +
                           ") in " + searched);
}

std::unique_ptr<Optimizer> LoadOptimizer(const std::string& name,
                                         const std::vector<std::string>& folders) {
  const std::string path = FindPlugin(name, folders);
  const Plugin plugin = OpenPlugin(path);
  return std::make_unique<PluginOptimizer>(path, plugin.table, plugin.covariances, plugin.state);
}

std::unique_ptr<Optimizer> LoadOptimizer(const std::string& name) {
  return LoadOptimizer(name, PluginSearchPath());
}

std::vector<BackendDescription> ListBackends(const std::vector<std::string>& folders) {
  std::map<std::string, BackendDescription> found;
  for (const std::string& folder : folders) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const std::string file = entry.path().filename().string();
      if (!file.starts_with(kPrefix) || entry.path().extension() != kSuffix) continue;
      const std::string name = entry.path().stem().string().substr(sizeof(kPrefix) - 1);
      if (found.contains(name)) continue;
      BackendDescription backend;
      backend.name = name;
      backend.path = entry.path().string();
      try {
        const Plugin plugin = OpenPlugin(backend.path);
        backend.description = plugin.table.description;
        backend.has_covariances = plugin.covariances != nullptr;
        backend.losses = LossesOf(plugin.table);
        backend.settings = SettingsOf(plugin.table);
        backend.loadable = true;
      } catch (const std::runtime_error& failure) {
        backend.description = failure.what();
      }
      found.emplace(name, std::move(backend));
    }
  }
  std::vector<BackendDescription> backends;
  backends.reserve(found.size());
  for (auto& [name, backend] : found) backends.push_back(std::move(backend));
  return backends;
}

}  // namespace gmapping_spa::backend
