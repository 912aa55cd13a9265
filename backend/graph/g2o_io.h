// SPDX-License-Identifier: BSD-3-Clause
// Pose graphs in the .g2o format and in its predecessor, TORO's .graph.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_G2O_IO_H_
#define GMAPPING_SPA_BACKEND_GRAPH_G2O_IO_H_

#include <cstdint>
#include <istream>
#include <map>
#include <ostream>
#include <string>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

struct G2oOptions {
  bool strict = false;  // refuse what would be left out or taken for something else
};

// What a file held that was left out or taken for something else: a line of text for each kind, and
// how often it occurred.
using G2oRemarks = std::map<std::string, std::int64_t>;

// Reads the records
//   VERTEX_SE2 id x y theta                         (TORO: VERTEX2, GTSAM: VERTEX)
//   EDGE_SE2 i j x y theta I11 I12 I13 I22 I23 I33
//   EDGE2    i j x y theta I11 I12 I22 I33 I13 I23  (TORO's order; GTSAM: EDGE, ODOMETRY)
//   EDGE_PRIOR_SE2 id x y theta I11 I12 I13 I22 I23 I33, EDGE_PRIOR_SE2_XY id x y I11 I12 I22
//   EDGE_SE2_SWITCHABLE i j switch ..., EDGE_SE2_MAXMIX i j weight ...   (vertigo; as EDGE_SE2)
//   FIX id...
// in any order, skipping blank lines, comments (from '#' to the end of a line), a byte order mark
// and PARAMS_... records; lines end as on any system. Units are metres and radians, information
// that of Edge. An edge between neighbors in the ascending order of the ids that exist is odometry,
// any other one a loop closure, since the format does not say. Priors become loop closures with a
// fixed node at the origin, whose id is the largest plus one; edges of such a node are loop
// closures when it is read back. A file without vertices gets one for every id that is named, in
// ascending order, placed along the odometry chain from the origin; else every id that is used must
// have its vertex.
//
// Left out, with a remark: edges from a node to itself, edges whose information is zero or not
// positive semidefinite, and records that say nothing about poses (VERTEX_SWITCH,
// EDGE_SWITCH_PRIOR, EQUIV). `name` is for messages. Throws std::runtime_error "<name>:<line>:
// <what was expected and found>" on anything else: unknown (landmarks, 3D) or malformed records,
// numbers that are not finite, a second vertex of the same id, ids without a vertex.
PoseGraph ReadG2o(std::istream& in, const std::string& name, const G2oOptions& options = {},
                  G2oRemarks* remarks = nullptr);

// Writes VERTEX_SE2, FIX and EDGE_SE2 records, numbers with up to 17 digits so that ReadG2o gives
// back the same values. Stamps (see stamps_io.h) and kinds of edges have no place in the format.
void WriteG2o(const PoseGraph& graph, std::ostream& out);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_G2O_IO_H_
