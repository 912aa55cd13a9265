// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/plugin.h"
#include "backend/spa/spa_optimizer.h"

GMAPPING_SPA_BACKEND_PLUGIN(gmapping_spa::spa::SpaOptimizer, "spa",
                            "Sparse Pose Adjustment on 3x3 blocks");
GMAPPING_SPA_BACKEND_COVARIANCES(gmapping_spa::spa::SpaOptimizer);
GMAPPING_SPA_BACKEND_STATE(gmapping_spa::spa::SpaOptimizer);
