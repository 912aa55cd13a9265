// SPDX-License-Identifier: BSD-3-Clause
// The ranges of a scan where numpy has them.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_RANGES_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_RANGES_H_

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstring>
#include <string>

namespace gmapping_spa::python {

// Reads float32 and float64 where they lie, of any stride; what else numpy can make numbers of is
// converted to float64.
class RangesView {
 public:
  // Throws pybind11::value_error unless `value` is one-dimensional and of real numbers, a million
  // at most.
  explicit RangesView(const pybind11::object& value) : array_(pybind11::array::ensure(value)) {
    namespace py = pybind11;
    constexpr py::ssize_t kMostBeams = 1'000'000;
    if (!array_) {
      PyErr_Clear();
      throw py::value_error("ranges_m: expected an array of numbers");
    }
    if (array_.ndim() != 1 || array_.size() > kMostBeams ||
        std::strchr("fiu", array_.dtype().kind()) == nullptr) {
      throw py::value_error(
          "ranges_m: expected a one-dimensional array of real numbers, a million "
          "at most, found shape " +
          std::string(py::str(array_.attr("shape"))) + " and type " +
          std::string(py::str(array_.dtype())));
    }
    is_float32_ = array_.dtype().equal(py::dtype::of<float>());
    if (!is_float32_ && !array_.dtype().equal(py::dtype::of<double>())) {
      array_ = py::array_t<double, py::array::forcecast>::ensure(array_);
    }
  }

  std::size_t size() const { return static_cast<std::size_t>(array_.size()); }

  // Calls `use` with a function that gives the range of a beam.
  template <typename Use>
  void Visit(const Use& use) const {
    if (is_float32_) {
      use([this](std::size_t beam) { return At<float>(beam); });
    } else {
      use([this](std::size_t beam) { return At<double>(beam); });
    }
  }

 private:
  // The elements of a structured array need not be aligned.
  template <typename T>
  T At(std::size_t beam) const {
    T value;
    std::memcpy(&value,
                static_cast<const char*>(array_.data()) +
                    static_cast<std::ptrdiff_t>(beam) * array_.strides(0),
                sizeof(T));
    return value;
  }

  pybind11::array array_;
  bool is_float32_ = false;
};

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_RANGES_H_
