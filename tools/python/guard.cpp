#include "python/bindings.hpp"
namespace flashbvh::python {
void add_guards(py::module_&) {}
}  // namespace flashbvh::python
