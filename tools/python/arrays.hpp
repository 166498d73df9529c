// Arrays of numpy as arguments and results. An invalid array is a ValueError that names the
// argument and the expected shape.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::python {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

/// An argument: its name, and the end of its shape. An empty end means a single number.
struct Argument {
  const char* name;
  Shape ends_in;
};

/// Finite numbers of an argument.
struct Numbers {
  Doubles array;
  Shape shape;        ///< outer shape: () for one element, or (N,)
  std::size_t count;  ///< number of elements
  const double* data;
};

/// One element of the argument's shape, or N of them.
Numbers numbers(const py::object& given, const Argument& argument);
/// N elements; refuses a single element.
Numbers rows(const py::object& given, const Argument& argument);
Integers integer_rows(const py::object& given, const Argument& argument);

/// An array of results, and its memory, which is written without Python's lock. `Row`: as
/// for array_of().
template <class Row>
struct Results {
  explicit Results(const Shape& shape)
      : array(py::dtype::of<Row>(), shape), data(static_cast<Row*>(array.mutable_data())) {}

  py::array array;
  Row* data;
};

/// A copy. Rows of numbers make a second dimension; structs with a numpy dtype, a structured array.
template <class Row>
py::array array_of(const std::vector<Row>& rows) {
  return py::array(py::dtype::of<Row>(), static_cast<py::ssize_t>(rows.size()), rows.data());
}

/// The ids of a pair of triangles; -1 if there is none.
template <class Pair>
std::array<std::int64_t, 2> ids_of(const Pair& pair, bool is_found) {
  return {is_found ? std::int64_t{pair.a} : -1, is_found ? std::int64_t{pair.b} : -1};
}

/// A finite number above 0.
double positive(double value, const char* name);

/// Text of a file or a message, which may not be valid UTF-8.
py::str text(const std::string& bytes);
/// The path in a str, bytes or os.PathLike, as bytes; else a TypeError.
std::string path_of(const py::object& path);

}  // namespace flashbvh::python
