// SPDX-License-Identifier: BSD-3-Clause
// Errors of trajectories.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <string>
#include <vector>

#include "backend/enum_names.h"
#include "experiments/apps/input_file.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/relations.h"
#include "experiments/metrics/trajectory_error.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using backend::EnumName;
using metrics::Alignment, metrics::PoseErrorSummary, metrics::Relation, metrics::RelationsSummary,
    metrics::Statistics, metrics::StepUnit;

constexpr EnumName<Alignment> kAlignments[] = {
    {"none", Alignment::kNone}, {"first", Alignment::kFirst}, {"se2", Alignment::kSe2}};
constexpr EnumName<StepUnit> kUnits[] = {
    {"frames", StepUnit::kFrames}, {"m", StepUnit::kMetres}, {"s", StepUnit::kSeconds}};

template <typename Enum, std::size_t kCount>
Enum Choice(const EnumName<Enum> (&names)[kCount], const std::string& name, const char* what) {
  const std::optional<Enum> value = ValueOf(names, name);
  if (value) return *value;
  throw py::value_error(std::string(what) + ": expected one of " + ListOf(names) + ", found '" +
                        name + "'");
}

double Gap(double max_gap_s) {
  if (max_gap_s >= 0.0) return max_gap_s;
  throw py::value_error("max_gap_s: expected a number from 0");
}

std::vector<Relation> ReadRelations(const std::filesystem::path& path) {
  return metrics::ReadRelations(*apps::OpenInput(path.string()), path.string());
}

std::vector<metrics::PosePair> Pairs(const py::object& truth, const py::object& estimate,
                                     double max_gap_s) {
  return metrics::AssociateByStamp(ToVector<backend::StampedPose>(truth, "truth"),
                                   ToVector<backend::StampedPose>(estimate, "estimate"),
                                   Gap(max_gap_s));
}

void BindStatistics(py::module_& module) {
  py::class_<Statistics>(module, "Statistics",
                         "What is reported of a set of errors, in their unit.")
      .def_readonly("rmse", &Statistics::rmse)
      .def_readonly("mean", &Statistics::mean)
      .def_readonly("median", &Statistics::median)
      .def_readonly("std", &Statistics::std, "Of the population: divided by n.")
      .def_readonly("min", &Statistics::min)
      .def_readonly("max", &Statistics::max)
      .def("__repr__", [](const Statistics& s) {
        return py::str("<Statistics: mean {}, std {}, rmse {}, max {}>")
            .format(s.mean, s.std, s.rmse, s.max);
      });
}

}  // namespace

void BindMetrics(py::module_& module) {
  BindStatistics(module);
  py::class_<Relation>(module, "Relation", "True motion of the robot between two moments.")
      .def(py::init([](double stamp_i_s, double stamp_j_s, const py::object& i_T_j) {
             if (!std::isfinite(stamp_i_s) || !std::isfinite(stamp_j_s)) {
               throw py::value_error("expected finite stamps");
             }
             return Relation{stamp_i_s, stamp_j_s, ToPose(i_T_j, "i_T_j")};
           }),
           py::arg("stamp_i_s"), py::arg("stamp_j_s"), py::arg("i_T_j"),
           "i_T_j: pose (x, y, theta) at j in the frame of the robot at i, m and rad.")
      .def_readonly("stamp_i_s", &Relation::stamp_i_s, "s")
      .def_readonly("stamp_j_s", &Relation::stamp_j_s, "s")
      .def_property_readonly(
          "i_T_j", [](const Relation& relation) { return ToArray(relation.i_T_j); },
          "[x, y, theta] in m and rad.");
  py::class_<RelationsSummary>(module, "RelationErrors", "Errors of a trajectory's relations.")
      .def_readonly("used", &RelationsSummary::used, "Relations that count.")
      .def_readonly("not_associated", &RelationsSummary::not_associated,
                    "Relations without a pose near one of their moments.")
      .def_readonly("translation_m", &RelationsSummary::translation_m)
      .def_readonly("rotation_deg", &RelationsSummary::rotation_deg);
  py::class_<PoseErrorSummary>(module, "PoseErrors", "Errors of a trajectory's poses.")
      .def_readonly("pairs", &PoseErrorSummary::pairs, "Pairs of poses, or of steps.")
      .def_readonly("translation_m", &PoseErrorSummary::translation_m)
      .def_readonly("rotation_deg", &PoseErrorSummary::rotation_deg);
  module.def(
      "read_relations", &ReadRelations, py::arg("path"),
      "Reads relations of the Freiburg benchmark, a list of Relation: lines \"t1 t2 x y z roll "
      "pitch yaw\". Raises RuntimeError \"file:line: expected ..., found ...\".");
  module.def(
      "evaluate_relations",
      [](const std::vector<Relation>& relations, const py::object& trajectory, double max_gap_s) {
        return metrics::EvaluateRelations(relations,
                                          ToVector<backend::StampedPose>(trajectory, "trajectory"),
                                          {.max_gap_s = Gap(max_gap_s)});
      },
      py::arg("relations"), py::arg("trajectory"), py::kw_only(),
      py::arg("max_gap_s") = metrics::RelationsOptions().max_gap_s,
      "The relations benchmark (Kuemmerle et al. 2009). A relation counts where both its moments "
      "have a stamp of the trajectory within max_gap_s. Raises RuntimeError when none counts.");
  module.def(
      "absolute_trajectory_error",
      [](const py::object& truth, const py::object& estimate, const std::string& alignment,
         double max_gap_s) {
        return metrics::AbsoluteTrajectoryError(Pairs(truth, estimate, max_gap_s),
                                                Choice(kAlignments, alignment, "alignment"));
      },
      py::arg("truth"), py::arg("estimate"), py::kw_only(), py::arg("alignment") = "se2",
      py::arg("max_gap_s") = 0.01,
      "Absolute trajectory error (Sturm et al. 2012), with the conventions of evo: distances of "
      "the "
      "positions and angles between the headings, once the estimate is aligned: se2 (least "
      "squares; where the positions leave the rotation open, by the headings), "
      "first (first poses laid over each other), none. Raises RuntimeError without a pair of poses "
      "within max_gap_s.");
  module.def(
      "relative_pose_error",
      [](const py::object& truth, const py::object& estimate, double step, const std::string& unit,
         double max_gap_s) {
        return metrics::RelativePoseError(Pairs(truth, estimate, max_gap_s),
                                          {step, Choice(kUnits, unit, "unit")});
      },
      py::arg("truth"), py::arg("estimate"), py::kw_only(), py::arg("step") = 1.0,
      py::arg("unit") = "frames", py::arg("max_gap_s") = 0.01,
      "Relative pose error over steps of so many frames, m or s that follow each other. Raises "
      "ValueError on a step that is not positive, RuntimeError when no step fits.");
}

}  // namespace gmapping_spa::python
