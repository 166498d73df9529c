// Arrays of numpy as arguments and results. An invalid array is a ValueError that names the
// argument and the expected shape.
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

/// An argument: its name, and the end of its shape. An empty end means a single number.
struct Argument {
  const char* name;
  Shape ends_in;
};

/// Finite numbers: one element of the argument's shape, or N of them.
Doubles numbers(const py::object& given, const Argument& argument);
/// Finite numbers: N elements; refuses a single element.
Doubles rows(const py::object& given, const Argument& argument);
Integers integer_rows(const py::object& given, const Argument& argument);

/// The number of elements in the array, and their outer shape: () or (N,).
std::size_t count_of(const Doubles& array, const Argument& argument);
Shape outer_shape(const Doubles& array, const Argument& argument);
/// An outer shape followed by `inner`.
Shape with(Shape outer, py::ssize_t inner);

/// A finite number above 0.
double positive(double value, const char* name);

/// Text of a file or a message, which may not be valid UTF-8.
py::str text(const std::string& bytes);
/// The path in a str, bytes or os.PathLike, as bytes; else a TypeError.
std::string path_of(const py::object& path);

}  // namespace flashbvh::python
