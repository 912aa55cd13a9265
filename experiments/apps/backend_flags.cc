// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/backend_flags.h"

#include <gflags/gflags.h>
#include <glog/logging.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "backend/plugin/plugin_loader.h"
#include "backend/plugin/process_optimizer.h"
#include "backend/scheduling/optimize.h"

namespace {
const gmapping_spa::backend::Options kOptions;
}

DEFINE_string(backend, "spa",
              "Back end that optimizes the pose graph: spa, ceres, none, the name of another one "
              "in $GMAPPING_SPA_PLUGIN_PATH, or the path of its shared library.");
DEFINE_double(
    backend_timeout_s, 0.0,
    "Longest wall time of one call of the back end in s, above 0: it runs in a process of "
    "its own, which is killed then. The optimization has failed then, or when the process "
    "crashes; the program goes on. inf: no limit. 0: it runs in the program itself, which "
    "ends with it when it crashes and cannot stop it.");
DEFINE_string(init, gmapping_spa::backend::InitializationName(kOptions.initialization),
              "Initialization of the poses before an optimization: auto (the back end chooses), "
              "keep (the poses given), odometry (along successive nodes), spanning_tree or chordal "
              "(chordal initialization of Carlone et al. 2015).");
DEFINE_int32(max_iterations, kOptions.max_iterations,
             "Largest number of iterations of an optimization, from 0.");
DEFINE_double(cost_tolerance, kOptions.cost_tolerance,
              "Relative decrease of the cost, from 0: an optimization has converged when a step "
              "lowers the cost by less than this part of it.");
DEFINE_double(max_solver_time_s, 0.0,
              "Longest wall time of an optimization in s, from 0: then it ends with the best poses "
              "so far, which depend on the speed of the machine. 0: no limit.");
DEFINE_string(loss, "mixture",
              "Robust loss of loop closures in the pose graph: mixture (a mixture of right and "
              "wrong closures is fitted to their errors, and least squares of the right ones; none "
              "where the back end has no dcs, which that needs), none, huber, cauchy, dcs (dynamic "
              "covariance scaling, Agarwal et al. 2013) or truncated (truncated least squares).");
DEFINE_double(loss_scale, 3.0,
              "Error of a loop closure in standard deviations, above 0, from which on the losses "
              "huber, cauchy, dcs and truncated lower its weight.");
DEFINE_bool(gnc, true,
            "Approach --loss=truncated by graduated non-convexity (Yang et al. 2020): the loss "
            "starts convex. Without it, the truncated loss is there from the first iteration.");
DEFINE_string(backend_settings, "",
              "Settings of a back end that has no flags here: name=value,name=value,... Empty: its "
              "defaults.");

// Flags of the form --<backend>_<setting>; their defaults are the back ends' own.
DEFINE_string(spa_solver, "block",
              "Linear solver of spa: block (Cholesky factorization of 3x3 blocks) or cholmod.");
DEFINE_double(spa_damping, 0.0,
              "Initial damping lambda of spa (Levenberg-Marquardt, eq. 5), from 0; 0: Gauss-Newton "
              "until a step fails.");
DEFINE_int32(spa_max_nonmonotonic_steps, 2,
             "Number of steps in succession, from 0, that spa may take without lowering the cost "
             "before it starts to damp.");
DEFINE_int32(spa_threads, 1,
             "Number of threads, from 1, that spa may use to factorize a large graph (some ten "
             "thousand poses or more). The result does not depend on it.");
DEFINE_string(
    ceres_linear_solver, "sparse_normal_cholesky",
    "Linear solver of ceres: sparse_normal_cholesky, dense_normal_cholesky, dense_qr or cgnr.");
DEFINE_string(ceres_sparse_library, "suite_sparse",
              "Sparse linear algebra of ceres: suite_sparse or eigen_sparse.");
DEFINE_string(ceres_trust_region, "levenberg_marquardt",
              "Trust region strategy of ceres: levenberg_marquardt or dogleg.");
DEFINE_double(ceres_initial_radius, 1e4,
              "Initial radius of the trust region of ceres, above 0, without unit; 1e16 is nearly "
              "Gauss-Newton.");
DEFINE_bool(ceres_nonmonotonic, false,
            "Nonmonotonic steps of ceres: steps that raise the cost are allowed for a while.");
DEFINE_bool(ceres_jacobi_scaling, true,
            "Jacobi scaling of ceres: the columns of the Jacobian are scaled by their norms.");
DEFINE_double(ceres_gradient_tolerance, 1e-10,
              "Gradient tolerance of ceres, from 0: it has converged when the largest component of "
              "the gradient of the cost (per m or rad) is below this.");
DEFINE_double(ceres_parameter_tolerance, 1e-8,
              "Parameter tolerance of ceres, from 0: it has converged when the norm of a step is "
              "below this part of the norm of all poses.");
DEFINE_int32(ceres_threads, 1, "Number of threads of ceres, from 1.");

namespace gmapping_spa::apps {
namespace {

// The flags of the form --<backend>_<setting>, by the names of the back ends.
const FlagGroups& SettingFlagGroups() {
  static const auto& groups =
      *new FlagGroups{{"spa",
                       "Back end spa",
                       {"spa_solver", "spa_damping", "spa_max_nonmonotonic_steps", "spa_threads"}},
                      {"ceres",
                       "Back end ceres",
                       {"ceres_linear_solver", "ceres_sparse_library", "ceres_trust_region",
                        "ceres_initial_radius", "ceres_nonmonotonic", "ceres_jacobi_scaling",
                        "ceres_gradient_tolerance", "ceres_parameter_tolerance", "ceres_threads"}}};
  return groups;
}

// Those flags of a group that differ from their defaults.
std::vector<gflags::CommandLineFlagInfo> ChangedFlags(const FlagGroup& group) {
  std::vector<gflags::CommandLineFlagInfo> changed;
  for (const std::string& name : group.flags) {
    const auto flag = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
    if (!flag.is_default) changed.push_back(flag);
  }
  return changed;
}

void AddFlagsOfBackend(backend::Options* options) {
  for (const FlagGroup& group : SettingFlagGroups()) {
    if (group.name != FLAGS_backend) continue;
    for (const gflags::CommandLineFlagInfo& flag : ChangedFlags(group)) {
      options->settings[flag.name.substr(group.name.size() + 1)] = flag.current_value;
    }
  }
}

void WarnOfFlagsWithoutEffect() {
  for (const FlagGroup& group : SettingFlagGroups()) {
    if (group.name == FLAGS_backend) continue;
    for (const gflags::CommandLineFlagInfo& flag : ChangedFlags(group)) {
      LOG(WARNING) << "--" << flag.name << " has no effect with --backend=" << FLAGS_backend;
    }
  }
}

// The default loss is no reason for a back end that has no robust losses to be refused.
void LeaveOutMixtureWhereUnsupported(const backend::Optimizer& optimizer) {
  const backend::Options options = OptionsFromFlags();
  if (options.loss.kind != backend::LossKind::kMixture ||
      !gflags::GetCommandLineFlagInfoOrDie("loss").is_default) {
    return;
  }
  try {
    backend::CheckOptions(options, optimizer);
  } catch (const std::runtime_error&) {
    backend::Options plain = options;
    plain.loss = {};
    optimizer.CheckOptions(plain);  // throws when it is not the loss
    gflags::SetCommandLineOptionWithMode("loss", "none", gflags::SET_FLAGS_DEFAULT);
    LOG(WARNING) << "--backend=" << FLAGS_backend
                 << " does not support the loss dcs, which --loss=mixture needs: --loss=none";
  }
}

void AddBackendSettings(backend::Options* options) {
  std::istringstream words(FLAGS_backend_settings);
  for (std::string word; std::getline(words, word, ',');) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw std::runtime_error("--backend_settings: expected name=value, found '" + word + "'");
    }
    options->settings[word.substr(0, equals)] = word.substr(equals + 1);
  }
}

}  // namespace

FlagGroups BackendFlagGroups() {
  const FlagGroups common = {
      {"backend",
       "Back end",
       {"backend", "backend_settings", "backend_timeout_s", "init", "max_iterations",
        "cost_tolerance", "max_solver_time_s", "loss", "loss_scale", "gnc"}}};
  return Join({common, SettingFlagGroups()});
}

std::string BackendFromFlags() { return FLAGS_backend; }

bool GncFromFlags() { return FLAGS_gnc; }

std::function<std::unique_ptr<backend::Optimizer>()> OptimizerLoaderFromFlags() {
  if (!(FLAGS_backend_timeout_s >= 0))
    throw std::runtime_error("--backend_timeout_s: expected a number from 0");
  return [name = FLAGS_backend,
          timeout_s = FLAGS_backend_timeout_s]() -> std::unique_ptr<backend::Optimizer> {
    if (timeout_s == 0) return backend::LoadOptimizer(name);
    return std::make_unique<backend::ProcessOptimizer>(name, timeout_s);
  };
}

std::unique_ptr<backend::Optimizer> LoadOptimizerFromFlags() {
  std::unique_ptr<backend::Optimizer> optimizer = OptimizerLoaderFromFlags()();
  LeaveOutMixtureWhereUnsupported(*optimizer);
  backend::CheckOptions(OptionsFromFlags(), *optimizer);
  WarnOfFlagsWithoutEffect();
  return optimizer;
}

backend::Options OptionsFromFlags() {
  if (FLAGS_max_iterations < 0)
    throw std::runtime_error("--max_iterations: expected a number from 0");
  if (!(FLAGS_cost_tolerance >= 0))
    throw std::runtime_error("--cost_tolerance: expected a number from 0");
  if (!(FLAGS_loss_scale > 0)) throw std::runtime_error("--loss_scale: expected a number above 0");
  if (!(FLAGS_max_solver_time_s >= 0))
    throw std::runtime_error("--max_solver_time_s: expected a number from 0");
  backend::Options options;
  if (FLAGS_max_solver_time_s > 0) options.max_solver_time_s = FLAGS_max_solver_time_s;
  options.max_iterations = FLAGS_max_iterations;
  options.initialization = backend::InitializationFromName(FLAGS_init);
  options.cost_tolerance = FLAGS_cost_tolerance;
  options.loss = {backend::LossKindFromName(FLAGS_loss), FLAGS_loss_scale};
  AddFlagsOfBackend(&options);
  AddBackendSettings(&options);
  return options;
}

backend::Summary OptimizeAsFlagsSay(backend::Optimizer* optimizer, backend::PoseGraph* graph) {
  const backend::Options options = OptionsFromFlags();
  return backend::Optimize(options, FLAGS_gnc, optimizer, graph);
}

}  // namespace gmapping_spa::apps
