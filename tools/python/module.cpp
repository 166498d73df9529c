// The native part of the Python package flashbvh: components of the host program and the library's
// queries.
#include "python/bindings.hpp"

namespace flashbvh::python {
namespace {

/// A class of the package's Python part.
py::object class_of(const char* name) {
  return py::module_::import("flashbvh._errors").attr(name);
}

/// Messages may quote files that are not valid UTF-8.
void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const tool::UserError& error) {
    PyErr_SetObject(class_of("Error").ptr(), text(tool::one_line(error.what())).ptr());
  }
}

}  // namespace

void warn(const tool::Warnings& warnings) {
  for (const tool::PlacedWarning& warning : warnings.all()) {
    const std::string line = tool::one_line(warning.place + ": " + warning.what);
    const std::string utf8 = text(line);
    if (PyErr_WarnEx(class_of("BakeWarning").ptr(), utf8.c_str(), 2) != 0) {
      throw py::error_already_set();
    }
  }
}

PYBIND11_MODULE(_native, module) {
  py::register_exception_translator(translate);
  add_meshes(module);
  add_mesh_queries(module);
  add_motions(module);
  add_robots(module);
  add_guards(module);
}

}  // namespace flashbvh::python
