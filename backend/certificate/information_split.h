// SPDX-License-Identifier: BSD-3-Clause
// The isotropic part of an information matrix.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_INFORMATION_SPLIT_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_INFORMATION_SPLIT_H_

#include <Eigen/Core>

namespace gmapping_spa::backend {

// Two numbers such that information - diag(translation, translation, rotation) is positive
// semidefinite, rounding included.
struct InformationSplit {
  double translation = 0.0;  // 1 / m^2
  double rotation = 0.0;     // 1 / rad^2
};

// The largest multiple of (smallest eigenvalue of the translation's block, information of the
// angle) that there is: both themselves where translation and angle are independent. Zeros where
// the two are coupled and one of them is not known at all.
InformationSplit SplitInformation(const Eigen::Matrix3d& information);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_INFORMATION_SPLIT_H_
