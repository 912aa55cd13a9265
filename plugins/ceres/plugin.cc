#include "backend/plugin/plugin.h"
#include "plugins/ceres/ceres_optimizer.h"

GMAPPING_SPA_BACKEND_PLUGIN(
    gmapping_spa::ceres_backend::CeresOptimizer, "ceres",
    "Ceres' trust-region solver; settings: linear_solver, sparse_library, trust_region, "
    "initial_radius, nonmonotonic, jacobi_scaling, gradient_tolerance, parameter_tolerance, "
    "threads");
