// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/plugin.h"
#include "plugins/ceres/ceres_optimizer.h"

GMAPPING_SPA_BACKEND_PLUGIN(gmapping_spa::ceres_backend::CeresOptimizer, "ceres",
                            "Ceres' trust-region solver");
GMAPPING_SPA_BACKEND_COVARIANCES(gmapping_spa::ceres_backend::CeresOptimizer);
GMAPPING_SPA_BACKEND_STATE(gmapping_spa::ceres_backend::CeresOptimizer);
