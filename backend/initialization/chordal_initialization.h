// SPDX-License-Identifier: BSD-3-Clause
// Initial poses from the chordal relaxation: no start needed, so no wrong basin to start in.
#ifndef GMAPPING_SPA_BACKEND_INITIALIZATION_CHORDAL_INITIALIZATION_H_
#define GMAPPING_SPA_BACKEND_INITIALIZATION_CHORDAL_INITIALIZATION_H_

#include <vector>

#include "backend/graph/pose_graph.h"
#
#include "backend/sparse/normal_equations.h"
#include "backend/sparse/sparse_cholesky.h"

namespace gmapping_spa::spa {

// Memory that a solve needs, kept from one to the next.
struct SolverMemory {
  NormalEquations equations;
  SparseCholesky cholesky;
};

// Two linear least-squares problems on the structure of the graph (Carlone, Tron, Daniilidis,
// Dellaert 2015, "Initialization techniques for 3D SLAM", section III-B, in the plane):
// the rotations as vectors (cos, sin) that need not have unit length, then all poses with the
// rotations linearised where the first problem put them. Held nodes stay where `poses` has them;
// free ones are replaced. Returns false, with `poses` undefined, when the information of the
// edges does not determine the poses.
bool InitializeChordal(const backend::PoseGraphView& graph, const GraphStructure& structure,
                       SolverMemory* memory, std::vector<backend::SE2>* poses);

// The second of the two problems alone: minimises the cost with the errors linearised about the
// angles of `poses`. Else like it.
bool InitializeFromRotations(const backend::PoseGraphView& graph, const GraphStructure& structure,
                             SolverMemory* memory, std::vector<backend::SE2>* poses);

// The chordal relaxation of rotations and translations in one linear problem: where angles are
// noisier than translations, the shape of the path tells more of the rotations than their own
// measurements. Coarser than InitializeChordal elsewhere. Else like it.
bool InitializeChordalJointly(const backend::PoseGraphView& graph, const GraphStructure& structure,
                              SolverMemory* memory, std::vector<backend::SE2>* poses);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_INITIALIZATION_CHORDAL_INITIALIZATION_H_
