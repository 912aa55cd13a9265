// SPDX-License-Identifier: BSD-3-Clause
// Stands for cholmod_solver.cc in a build without CHOLMOD, whose settings do not offer it.
#include <stdexcept>

#include "backend/sparse/cholmod_solver.h"

namespace gmapping_spa::spa {

struct CholmodSolver::Workspace {};

CholmodSolver::CholmodSolver() = default;
CholmodSolver::~CholmodSolver() = default;

bool CholmodSolver::Solve(const BlockStructure& /*structure*/, const PoseMatrix& /*matrix*/,
                          bool /*new_structure*/, PoseMatrix::Vector* /*x*/) {
  throw std::logic_error("built without CHOLMOD");
}

}  // namespace gmapping_spa::spa
