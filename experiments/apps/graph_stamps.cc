// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/graph_stamps.h"

#include <filesystem>

#include "backend/graph/stamps_io.h"
#include "experiments/apps/input_file.h"

namespace gmapping_spa::apps {

std::string StampsPathOf(const std::string& graph_path) {
  std::filesystem::path path(graph_path);
  if (path.extension() == ".gz") path.replace_extension();
  return path.empty() ? "" : path.replace_extension(".stamps").string();
}

bool ReadStampsBeside(const std::string& graph_path, backend::PoseGraph* graph) {
  const std::string path = StampsPathOf(graph_path);
  if (!std::filesystem::exists(path)) return false;
  backend::ReadStamps(*OpenInput(path), path, graph);
  return true;
}

}  // namespace gmapping_spa::apps
