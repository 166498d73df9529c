// The parts of the module: each function adds classes and functions.
#pragma once

#include "python/arrays.hpp"
#include "text/messages.hpp"

namespace flashbvh::python {

/// Issues Python warnings, BakeWarning. Throws if the user turned them into errors.
void warn(const tool::Warnings& warnings);

void add_meshes(py::module_& module);
void add_mesh_queries(py::module_& module);
void add_motions(py::module_& module);
void add_robots(py::module_& module);
void add_guards(py::module_& module);

}  // namespace flashbvh::python
