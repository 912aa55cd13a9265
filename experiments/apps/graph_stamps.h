// SPDX-License-Identifier: BSD-3-Clause
// The file of stamps beside the file of a graph.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_STAMPS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_STAMPS_H_

#include <string>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::apps {

// graph.stamps of graph.g2o, graph.graph and graph.g2o.gz; empty of an empty path.
std::string StampsPathOf(const std::string& graph_path);

// Gives the nodes the stamps of that file; false where there is none. Throws std::runtime_error
// with one line when it is not of this graph.
bool ReadStampsBeside(const std::string& graph_path, backend::PoseGraph* graph);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_STAMPS_H_
