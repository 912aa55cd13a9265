// SPDX-License-Identifier: BSD-3-Clause
// The options of SLAM: an attribute for each flag of the executable.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "backend/cost/robust_loss.h"
#include "backend/initialization/initialization.h"
#include "experiments/apps/slam_option_names.h"
#include "experiments/python/bindings.h"
#include "frontend/api/slam_options.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using Class = py::class_<SlamOptions>;
using apps::kCorrectionNames, apps::kEdgeInformationNames, apps::kEdgeMeasurementNames,
    apps::kGraphThreadNames, apps::kLikelihoodNames, apps::kMatchStartNames,
    apps::kMotionNoiseNames, apps::kOdometryNames, apps::kProposalNames, apps::kScanMatcherNames;

// A choice is its name on the command line.
template <typename Enum, std::size_t kCount>
void Choice(Class* options, const char* option, Enum SlamOptions::*member,
            const backend::EnumName<Enum> (&names)[kCount]) {
  options->def_property(
      option, [member, &names](const SlamOptions& o) { return NameOf(names, o.*member); },
      [member, &names, option](SlamOptions& o, const std::string& name) {
        const std::optional<Enum> value = ValueOf(names, name);
        if (!value) {
          throw py::value_error(std::string(option) + ": expected one of " + ListOf(names) +
                                ", found '" + name + "'");
        }
        o.*member = *value;
      },
      ListOf(names).c_str());
}

void BindFilter(Class* c) {
  using O = SlamOptions;
  c->def_readwrite("particles", &O::particles, "Number of particles.")
      .def_readwrite("seed", &O::seed, "Of all random numbers.")
      .def_readwrite("threads", &O::threads, "For the particles; results do not depend on it.")
      .def_readwrite("linear_update_m", &O::linear_update_m, "m")
      .def_readwrite("angular_update_rad", &O::angular_update_rad, "rad")
      .def_readwrite("resample_threshold", &O::resample_threshold, "Part of the particles.")
      .def_readwrite("obs_sigma_gain", &O::obs_sigma_gain, "")
      .def_readwrite("max_speed_m_s", &O::max_speed_m_s, "m/s")
      .def_readwrite("max_turn_rad_s", &O::max_turn_rad_s, "rad/s")
      .def_readwrite("sweep_duration_s", &O::sweep_duration_s, "s; None: learned.")
      .def_readwrite("motion_linear_per_linear", &O::motion_linear_per_linear, "m per m")
      .def_readwrite("motion_lateral_per_linear", &O::motion_lateral_per_linear, "m per m")
      .def_readwrite("motion_linear_per_angular", &O::motion_linear_per_angular, "m per rad")
      .def_readwrite("motion_angular_per_linear", &O::motion_angular_per_linear, "rad per m")
      .def_readwrite("motion_angular_per_angular", &O::motion_angular_per_angular, "rad per rad")
      .def_readwrite("motion_linear_floor_m", &O::motion_linear_floor_m, "m")
      .def_readwrite("motion_angular_floor_rad", &O::motion_angular_floor_rad, "rad");
  Choice(c, "odometry", &O::odometry, kOdometryNames);
  Choice(c, "motion_noise", &O::motion_noise, kMotionNoiseNames);
}

void BindMatching(Class* c) {
  using O = SlamOptions;
  c->def_readwrite("resolution_m", &O::resolution_m, "m")
      .def_readwrite("grid_occupied_threshold", &O::grid_occupied_threshold, "0 to 1")
      .def_readwrite("occupied_threshold", &O::occupied_threshold, "0 to 1")
      .def_readwrite("no_return_clears", &O::no_return_clears, "")
      .def_readwrite("initial_guesses", &O::initial_guesses, "")
      .def_readwrite("match_linear_step_m", &O::match_linear_step_m, "m")
      .def_readwrite("match_angular_step_rad", &O::match_angular_step_rad, "rad")
      .def_readwrite("match_refinements", &O::match_refinements, "")
      .def_readwrite("match_noise_m", &O::match_noise_m, "m")
      .def_readwrite("match_robust_sigmas", &O::match_robust_sigmas, "")
      .def_readwrite("match_min_score", &O::match_min_score, "0 to 1")
      .def_readwrite("score_sigma_m", &O::score_sigma_m, "m")
      .def_readwrite("free_cell_in_front", &O::free_cell_in_front, "")
      .def_readwrite("likelihood_sigma_m", &O::likelihood_sigma_m, "m")
      .def_readwrite("likelihood_gain", &O::likelihood_gain, "")
      .def_readwrite("unseen_is_miss", &O::unseen_is_miss, "")
      .def_readwrite("unmatched_sigmas", &O::unmatched_sigmas, "");
  Choice(c, "scan_matcher", &O::scan_matcher, kScanMatcherNames);
  Choice(c, "match_start", &O::match_start, kMatchStartNames);
  Choice(c, "proposal", &O::proposal, kProposalNames);
  Choice(c, "likelihood", &O::likelihood, kLikelihoodNames);
}

void BindPoseGraph(Class* c) {
  using O = SlamOptions;
  c->def_readwrite("loop_closure", &O::loop_closure, "")
      .def_readwrite("closure_min_path_length_m", &O::closure_min_path_length_m, "m")
      .def_readwrite("closure_max_distance_m", &O::closure_max_distance_m, "m")
      .def_readwrite("closure_drift_m_per_m", &O::closure_drift_m_per_m, "m per m")
      .def_readwrite("closure_drift_rad_per_m", &O::closure_drift_rad_per_m, "rad per m")
      .def_readwrite("closure_everywhere", &O::closure_everywhere, "")
      .def_readwrite("closure_min_score", &O::closure_min_score, "0 to 1")
      .def_readwrite("closure_max_runner_up_score", &O::closure_max_runner_up_score, "0 to 1")
      .def_readwrite("closure_min_overlap", &O::closure_min_overlap, "0 to 1")
      .def_readwrite("closure_min_inlier_ratio", &O::closure_min_inlier_ratio, "0 to 1")
      .def_readwrite("closure_information_gain", &O::closure_information_gain, "")
      .def_readwrite("gnc", &O::gnc, "")
      .def_readwrite("optimize_every", &O::optimize_every, "Nodes.")
      .def_readwrite("lockstep_scans", &O::lockstep_scans, "Scans.")
      .def_readwrite("graph_timeout_s", &O::graph_timeout_s, "s")
      .def_readwrite("final_optimization", &O::final_optimization, "")
      .def_readwrite("refine", &O::refine, "Rounds.");
  Choice(c, "edge_measurement", &O::edge_measurement, kEdgeMeasurementNames);
  Choice(c, "edge_information", &O::edge_information, kEdgeInformationNames);
  Choice(c, "graph_thread", &O::graph_thread, kGraphThreadNames);
  Choice(c, "correction", &O::correction, kCorrectionNames);
}

// An option of SlamOptions::optimizer, or of what is in it.
template <typename Part, typename Value>
void OfOptimizer(Class* c, const char* option, Part& (*part)(SlamOptions&), Value Part::*member,
                 const char* doc) {
  c->def_property(
      option, [=](SlamOptions& o) { return part(o).*member; },
      [=](SlamOptions& o, const Value& value) { part(o).*member = value; }, doc);
}

template <typename Function>
auto OrValueError(const char* option, const Function& function) {
  try {
    return function();
  } catch (const std::runtime_error& error) {
    throw py::value_error(std::string(option) + ": " + error.what());
  }
}

void BindBackend(Class* c) {
  using backend::Loss, backend::Options;
  const auto options = +[](SlamOptions& o) -> Options& { return o.optimizer; };
  const auto loss = +[](SlamOptions& o) -> Loss& { return o.optimizer.loss; };
  c->def_readwrite("backend", &SlamOptions::backend, "Name or path of a plugin.");
  OfOptimizer(c, "max_iterations", options, &Options::max_iterations, "");
  OfOptimizer(c, "cost_tolerance", options, &Options::cost_tolerance, "");
  OfOptimizer(c, "max_solver_time_s", options, &Options::max_solver_time_s, "s");
  OfOptimizer(c, "settings", options, &Options::settings, "Of the back end: a dict of texts.");
  OfOptimizer(c, "loss_scale", loss, &Loss::scale, "Standard deviations.");
  c->def_property(
      "loss", [](const SlamOptions& o) { return backend::LossKindName(o.optimizer.loss.kind); },
      [](SlamOptions& o, const std::string& name) {
        o.optimizer.loss.kind =
            OrValueError("loss", [&] { return backend::LossKindFromName(name); });
      },
      "none, huber, cauchy, dcs, truncated, mixture");
  c->def_property(
      "init",
      [](const SlamOptions& o) { return backend::InitializationName(o.optimizer.initialization); },
      [](SlamOptions& o, const std::string& name) {
        o.optimizer.initialization =
            OrValueError("init", [&] { return backend::InitializationFromName(name); });
      },
      "auto, keep, odometry, spanning_tree, chordal");
}

SlamOptions FromKeywords(const py::kwargs& keywords) {
  SlamOptions options;
  const py::object self = py::cast(&options, py::return_value_policy::reference);
  for (const auto& [name, value] : keywords) {
    if (!py::hasattr(py::type::of(self), name)) {
      throw py::type_error("SlamOptions: there is no option '" + std::string(py::str(name)) + "'");
    }
    py::setattr(self, name, value);
  }
  return options;
}

}  // namespace

void BindSlamOptions(py::module_& module) {
  Class c(
      module, "SlamOptions",
      "Everything that can be chosen about SLAM. Each attribute is the flag of the same name of "
      "the executable gmapping_spa, whose --help says what it means, with the same default; "
      "`settings` is --backend_settings. Numbers out of range are told when a Slam is made.");
  c.def(py::init(&FromKeywords),
        "Options by name, others at their defaults. Raises TypeError on an unknown name or a wrong "
        "type, ValueError on a choice that there is not.");
  BindFilter(&c);
  BindMatching(&c);
  BindPoseGraph(&c);
  BindBackend(&c);
  c.def_static("improved", &SlamOptions::Improved, "The defaults.")
      .def_static("plain_gmapping", &SlamOptions::PlainGmapping,
                  "GMapping as its authors published it, without a back end.")
      .def_static("paper", &SlamOptions::Paper, "Tao et al. 2021 read literally.")
      .def(
          "copy", [](const SlamOptions& o) { return o; }, "Options of their own.")
      .def(
          "__eq__", [](const SlamOptions& a, const SlamOptions& b) { return a == b; },
          py::is_operator());
  c.attr("__hash__") = py::none();
}

}  // namespace gmapping_spa::python
