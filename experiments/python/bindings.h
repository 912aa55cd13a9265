// SPDX-License-Identifier: BSD-3-Clause
// What the Python module is made of.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_BINDINGS_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_BINDINGS_H_

#include <pybind11/pybind11.h>

namespace gmapping_spa::python {

// Each adds its classes and functions to the module. Types are bound before what uses them.
void BindFiles(pybind11::module_& module);
void BindScan(pybind11::module_& module);
void BindMap(pybind11::module_& module);
void BindGraph(pybind11::module_& module);
void BindOptimize(pybind11::module_& module);
void BindAccuracy(pybind11::module_& module);
void BindSlamOptions(pybind11::module_& module);
void BindSlam(pybind11::module_& module);
void BindMetrics(pybind11::module_& module);
void BindSimulation(pybind11::module_& module);

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_BINDINGS_H_
