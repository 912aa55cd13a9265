// Pose graphs in the .g2o format and in its predecessor, TORO's .graph.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_G2O_IO_H_
#define GMAPPING_SPA_BACKEND_GRAPH_G2O_IO_H_

#include <istream>
#include <ostream>
#include <string>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Reads the records
//   VERTEX_SE2 id x y theta              (TORO: VERTEX2)
//   EDGE_SE2 i j x y theta I11 I12 I13 I22 I23 I33
//   EDGE2    i j x y theta I11 I12 I22 I33 I13 I23   (TORO's order)
//   FIX id...
// in any order, skipping blank lines, comments (from '#' to the end of a line) and a byte order
// mark. PARAMS_SE2OFFSET, which belongs to records that are not read, has no effect. Units are
// metres and radians, information that of Edge. An edge between neighbors in the ascending order of
// the ids that exist is odometry, any other one a loop closure, since the format does not say. A
// file without vertices gets one for every id that an edge names, in ascending order, placed along
// the odometry chain from the origin; else every id that is used must have its vertex. `name` is
// for messages. Throws std::runtime_error "<name>:<line>: <what was expected>" on anything else:
// unknown (landmarks, 3D) or malformed records, numbers that are not finite, a second vertex of the
// same id, ids without a vertex, an edge from a node to itself, information that is not positive
// definite.
PoseGraph ReadG2o(std::istream& in, const std::string& name);

// Writes VERTEX_SE2, FIX and EDGE_SE2 records, numbers with up to 17 digits so that ReadG2o gives
// back the same values. Stamps and kinds of edges have no place in the format.
void WriteG2o(const PoseGraph& graph, std::ostream& out);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_G2O_IO_H_
