// SPDX-License-Identifier: BSD-3-Clause
// Minimizing the chordal cost over lifted poses.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_DESCENT_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_DESCENT_H_

#include <vector>

#include "backend/certificate/chordal_cost.h"
#include "backend/certificate/lifted_solver.h"

namespace gmapping_spa::backend {

// A Riemannian trust region with truncated conjugate gradients (Absil, Baker, Gallivan 2007, as in
// SE-Sync), preconditioned by a factor of the cost's own matrix.
class LiftedDescent {
 public:
  struct Options {
    int max_products = 600;  // with the second derivative, each of which takes a substitution
    double cost_tolerance = 1e-4;
  };

  // The arguments must outlive the object.
  LiftedDescent(const spa::GraphStructure& structure, const ChordalCost& cost)
      : structure_(structure), cost_(cost) {}

  // Lowers the cost from `*poses` on. Returns the cost; nothing changes where the matrix is not
  // positive definite, that is where positions are not determined.
  double Minimize(const Options& options, LiftedPoses* poses);

 private:
  // A step, the decrease that the quadratic model promises, and whether it goes to the border.
  struct Step {
    LiftedPoses step;
    double predicted = 0.0;
    double norm = 0.0;
    bool at_border = false;
  };

  Step FindStep(const LiftedPoses& poses, const LiftedPoses& gradient, double radius,
                int* products) const;
  LiftedPoses Precondition(const LiftedPoses& poses, const LiftedPoses& gradient) const;

  const spa::GraphStructure& structure_;
  const ChordalCost& cost_;
  LiftedSolver solver_;
};

// Lifted poses as poses: rotations by the direction, among all of the lifted space, that most of
// them share, positions what follows. Held nodes stay where `poses` has them. False, with `*poses`
// undefined, when the edges do not determine the poses.
bool RoundPoses(const PoseGraphView& graph, const spa::GraphStructure& structure,
                const LiftedPoses& lifted, std::vector<SE2>* poses);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_DESCENT_H_
