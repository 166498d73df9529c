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

/// An array of results, and its memory, which is written without Python's lock.
template <class Number>
struct Results {
  /// The shape is an outer one, followed by `inner`.
  explicit Results(Shape outer, const Shape& inner = {}) {
    outer.insert(outer.end(), inner.begin(), inner.end());
    array = py::array_t<Number>(outer);
    data = array.mutable_data();
  }

  py::array_t<Number> array;
  Number* data;
};

/// Writes the ids of a pair of triangles; -1 if there is none.
template <class Pair>
void put_pair(std::int64_t* to, bool is_found, const Pair& pair) {
  to[0] = is_found ? std::int64_t{pair.a} : -1;
  to[1] = is_found ? std::int64_t{pair.b} : -1;
}

/// A finite number above 0.
double positive(double value, const char* name);

/// Text of a file or a message, which may not be valid UTF-8.
py::str text(const std::string& bytes);
/// The path in a str, bytes or os.PathLike, as bytes; else a TypeError.
std::string path_of(const py::object& path);

}  // namespace flashbvh::python
