#include "python/bindings.hpp"
namespace flashbvh::python {
void add_robots(py::module_&) {}
}  // namespace flashbvh::python
