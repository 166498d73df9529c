// Arrays of numpy as arguments and results. What is no such array is a ValueError that names the
// argument and what it should be.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::python {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style>;
using Integers = py::array_t<std::int64_t, py::array::c_style>;
using Shape = std::vector<py::ssize_t>;

/// An argument: its name, and what its shape ends in. None of the last is a single number.
struct Argument {
  const char* name;
  Shape ends_in;
};

/// Finite numbers: one element of the argument's shape, or N of them.
Doubles numbers(const py::object& given, const Argument& argument);
/// Finite numbers: N elements, a single one is refused.
Doubles rows(const py::object& given, const Argument& argument);
Integers integer_rows(const py::object& given, const Argument& argument);

/// How many elements the array has, and their shape: () or (N,).
std::size_t count_of(const Doubles& array, const Argument& argument);
Shape outer_shape(const Doubles& array, const Argument& argument);
/// An outer shape, and what comes behind it.
Shape with(Shape outer, py::ssize_t inner);

/// A finite number above 0.
double positive(double value, const char* name);

/// Text of a file or a message, which may be no UTF-8.
py::str text(const std::string& bytes);
/// A str, bytes or os.PathLike as the bytes of a path. TypeError if it is none.
std::string path_of(const py::object& path);

}  // namespace flashbvh::python
