#include "python/arrays.hpp"

#include <cmath>

#include "text/numbers.hpp"

namespace flashbvh::python {
namespace {

using tool::concat;

std::string shape_text(const char* outer, const Shape& shape) {
  std::string text = outer;
  for (const py::ssize_t size : shape) {
    text += concat(text.empty() ? "" : ", ", size);
  }
  return "(" + text + (text.find(',') == std::string::npos && !text.empty() ? ",)" : ")");
}

/// The expected shape, such as "(4, 4) or (N, 4, 4)".
std::string wanted(const Argument& argument, bool takes_one) {
  const std::string one = argument.ends_in.empty() ? "a number" : shape_text("", argument.ends_in);
  return (takes_one ? one + " or " : "") + shape_text("N", argument.ends_in);
}

template <class... Parts>
[[noreturn]] void refuse(const Argument& argument, const Parts&... parts) {
  throw py::value_error(concat(argument.name, ": ", parts...));
}

void check_shape(const py::array& array, const Argument& argument, bool takes_one) {
  const auto inner = static_cast<py::ssize_t>(argument.ends_in.size());
  const Shape shape(array.shape(), array.shape() + array.ndim());
  const bool fits = array.ndim() == inner + 1 || (takes_one && array.ndim() == inner);
  if (!fits || !std::equal(argument.ends_in.begin(), argument.ends_in.end(), shape.end() - inner)) {
    refuse(argument, "has the shape ", shape_text("", shape), "; give ",
           wanted(argument, takes_one));
  }
}

/// An array with one of these kinds of numbers, by numpy's letters for kinds.
py::array number_array(const py::object& given, const Argument& argument, bool takes_one,
                       const std::string& kinds, const char* kind_name) {
  py::array array = py::array::ensure(given);
  if (!array) {
    refuse(argument, "is no array; give ", kind_name, " of the shape ",
           wanted(argument, takes_one));
  }
  if (kinds.find(array.dtype().kind()) == std::string::npos) {
    refuse(argument, "has the dtype ", std::string(py::str(array.dtype())), "; give ", kind_name);
  }
  check_shape(array, argument, takes_one);
  return array;
}

Numbers numbers_of(const py::object& given, const Argument& argument, bool takes_one) {
  const Doubles doubles =
      Doubles::ensure(number_array(given, argument, takes_one, "fiu", "numbers (float64)"));
  if (!doubles) {
    refuse(argument, "is no array of float64");
  }
  const double* const values = doubles.data();
  for (py::ssize_t i = 0; i < doubles.size(); ++i) {
    if (!std::isfinite(values[i])) {
      const py::ssize_t row = doubles.size() / (doubles.ndim() == 0 ? 1 : doubles.shape(0));
      refuse(argument, "holds ", std::isnan(values[i]) ? "NaN" : "infinity", " in element ",
             i / row, "; give finite numbers");
    }
  }
  const auto inner = static_cast<py::ssize_t>(argument.ends_in.size());
  const Shape shape(doubles.shape(), doubles.shape() + doubles.ndim() - inner);
  return {doubles, shape, static_cast<std::size_t>(shape.empty() ? 1 : shape[0]), values};
}

}  // namespace

Numbers numbers(const py::object& given, const Argument& argument) {
  return numbers_of(given, argument, true);
}

Numbers rows(const py::object& given, const Argument& argument) {
  return numbers_of(given, argument, false);
}

Integers integer_rows(const py::object& given, const Argument& argument) {
  Integers integers = Integers::ensure(number_array(given, argument, false, "iu", "integers"));
  if (!integers) {
    refuse(argument, "is no array of integers");
  }
  return integers;
}

double positive(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw py::value_error(
        concat(name, ": is ", tool::significant(value, 6), "; give a positive, finite number"));
  }
  return value;
}

py::str text(const std::string& bytes) {
  PyObject* const made =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace");
  if (made == nullptr) {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::str>(made);
}

std::string path_of(const py::object& path) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(path.ptr(), &bytes) == 0) {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::bytes>(bytes);
}

}  // namespace flashbvh::python
