// The native part of the Python package flashbvh: components of the host program and the library's
// queries.
#include "python/bindings.hpp"

namespace flashbvh::python {
namespace {

py::object& error_class() {
  static py::object made;
  return made;
}

py::object new_class(const char* name, PyObject* base, const char* what) {
  PyObject* const made = PyErr_NewExceptionWithDoc(name, what, base, nullptr);
  if (made == nullptr) {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::object>(made);
}

/// Messages may quote files that are not valid UTF-8.
void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const tool::UserError& error) {
    PyErr_SetObject(error_class().ptr(), text(tool::one_line(error.what())).ptr());
  }
}

}  // namespace

py::object& warning_class() {
  static py::object made;
  return made;
}

void warn(const tool::Warnings& warnings) {
  for (const tool::PlacedWarning& warning : warnings.all()) {
    const std::string line = tool::one_line(warning.place + ": " + warning.what);
    const std::string utf8 = text(line);
    if (PyErr_WarnEx(warning_class().ptr(), utf8.c_str(), 2) != 0) {
      throw py::error_already_set();
    }
  }
}

PYBIND11_MODULE(_native, module) {
  error_class() = new_class("flashbvh.Error", PyExc_ValueError,
                            "What the program `flashbvh` refuses, with its message: what is wrong "
                            "where, and the remedy.");
  warning_class() = new_class("flashbvh.BakeWarning", PyExc_UserWarning,
                              "What the program `flashbvh` warns of, with its message.");
  module.attr("Error") = error_class();
  module.attr("BakeWarning") = warning_class();
  py::register_exception_translator(translate);
  add_meshes(module);
  add_mesh_queries(module);
  add_motions(module);
  add_robots(module);
  add_guards(module);
}

}  // namespace flashbvh::python
