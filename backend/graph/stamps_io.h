// SPDX-License-Identifier: BSD-3-Clause
// Stamps of the nodes of a graph, which have no place in a .g2o file: a file beside it, "id stamp"
// in each line. Comments or records of their own in the .g2o file would stop some of its readers
// (that of Ceres' examples among them).
#ifndef GMAPPING_SPA_BACKEND_GRAPH_STAMPS_IO_H_
#define GMAPPING_SPA_BACKEND_GRAPH_STAMPS_IO_H_

#include <istream>
#include <ostream>
#include <string>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Sets the stamps of the nodes, skipping blank lines and '#' comments; the order of lines is free.
// `name` is for messages. Throws std::runtime_error "<name>:<line>: <what was expected and found>"
// on anything but an id and a finite number, an id that is no node's, or a second stamp of a node,
// and "<name>: ..." when a node has none, but for fixed ones: the origin of priors is in no file.
// The graph is unchanged then.
void ReadStamps(std::istream& in, const std::string& name, PoseGraph* graph);

// A line for each node, in their order, with digits enough to read back the same stamp.
void WriteStamps(const PoseGraph& graph, std::ostream& out);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_STAMPS_IO_H_
