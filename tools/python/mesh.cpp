// Meshes of the Python package, before and after baking.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bake/image_bytes.hpp"
#include "cli/mesh/mesh_warnings.hpp"
#include "evaluate/queries.hpp"
#include "image/baking.hpp"
#include "mesh/import.hpp"
#include "python/bindings.hpp"
#include "python/images.hpp"

namespace flashbvh::python {
namespace {

using tool::concat;

/// A mesh before baking.
struct Mesh {
  tool::InputMesh input;
  std::optional<double> cell;  ///< for baking
};

std::optional<double> length_or_none(std::optional<double> length, const char* name) {
  return length ? positive(*length, name) : length;
}

Mesh mesh_of_file(const py::object& path, double scale, std::optional<double> cell) {
  const std::string file = path_of(path);
  (void)positive(scale, "scale");
  (void)length_or_none(cell, "cell");
  tool::Warnings warnings;
  Mesh mesh;
  {
    const py::gil_scoped_release release;
    mesh = {tool::read_mesh(file, {}, warnings), cell};
  }
  for (std::array<double, 3>& vertex : mesh.input.mesh.vertices) {
    for (double& coordinate : vertex) {
      coordinate *= scale;
      if (!tool::is_coordinate(coordinate)) {
        throw py::value_error("scale: makes the mesh too large for 32-bit floats");
      }
    }
  }
  mesh.input.precision *= scale;
  mesh.input.unit = scale == 1 ? mesh.input.unit : Unit::none;
  warn(warnings);
  return mesh;
}

void add_corners(const Numbers& vertices, const Integers& triangles, tool::MeshBuilder& builder) {
  for (std::size_t i = 0; i < vertices.count; ++i) {
    const double* const from = vertices.data + 3 * i;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!tool::is_coordinate(from[axis])) {
        throw py::value_error(concat("vertices: row ", i, " is too large for 32-bit floats"));
      }
    }
    builder.add_point({from[0], from[1], from[2]});
  }
  const std::int64_t* const corners = triangles.data();
  const auto count = static_cast<std::int64_t>(vertices.count);
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i) {
    std::vector<std::uint32_t> polygon;
    for (py::ssize_t corner = 3 * i; corner < 3 * i + 3; ++corner) {
      if (corners[corner] < 0 || corners[corner] >= count) {
        throw py::value_error(
            concat("triangles: row ", i, " names the vertex ", corners[corner], "; give ",
                   count == 0 ? "vertices, too: there are none" : concat("0 to ", count - 1)));
      }
      polygon.push_back(static_cast<std::uint32_t>(corners[corner]));
    }
    builder.add_polygon(polygon);
  }
}

Mesh mesh_of_arrays(const py::object& vertices, const py::object& triangles,
                    const std::string& name, std::optional<double> cell) {
  const Numbers points = rows(vertices, {"vertices", {3}});
  const Integers corners = integer_rows(triangles, {"triangles", {3}});
  (void)length_or_none(cell, "cell");
  if (points.count > 0xFFFFFFFE || corners.shape(0) > 0xFFFFFFFE) {
    throw py::value_error("triangles: more than 2^32 - 2 are too many");
  }
  tool::MeshBuilder builder(name);
  (void)builder.begin_body(name);
  add_corners(points, corners, builder);
  tool::FileMesh made = builder.finish();
  Mesh mesh;
  mesh.input.path = name;
  mesh.input.mesh = std::move(made.mesh);
  mesh.input.degenerate = tool::degenerate_triangles(mesh.input.mesh);
  mesh.cell = cell;
  return mesh;
}

/// UserError if the module's queries do not accept the image's layout.
std::unique_ptr<Baked> checked(std::unique_ptr<Baked> baked) {
  (void)tool::query_post_mesh<bool>(*baked, [](const auto&) { return true; });
  return baked;
}

/// The options of `flashbvh bake`.
struct Order {
  tool::BakeOptions options;
  Unit unit = Unit::none;
  std::optional<double> simplify;
};

Order order_of(std::optional<double> cell, const std::optional<std::string>& unit,
               std::uint32_t leaf_size, std::uint32_t arity, std::uint32_t index_bits,
               std::optional<double> max_deviation, std::optional<double> simplify) {
  const auto check = [](std::uint32_t value, const char* name, std::uint32_t least,
                        std::uint32_t most) {
    if (value < least || value > most) {
      throw py::value_error(concat(name, ": is ", value, "; give ", least, " to ", most));
    }
    return value;
  };
  Order order;
  if (unit) {
    const tool::Units units({*unit}, {});
    order.options.unit = units.common();
    order.unit = units.unit();
  }
  order.options.cell = length_or_none(cell, "cell");
  order.options.leaf_size = check(leaf_size, "leaf_size", 1, 16);
  order.options.arity = check(arity, "arity", 2, 8);
  if (index_bits != 16 && index_bits != 32) {
    throw py::value_error(concat("index_bits: is ", index_bits, "; give 16 or 32"));
  }
  order.options.index_width =
      index_bits == 16 ? tool::IndexWidth::bits_16 : tool::IndexWidth::bits_32;
  if (max_deviation && !(*max_deviation >= 0 && std::isfinite(*max_deviation))) {
    throw py::value_error("max_deviation: is no length; give a number from 0");
  }
  order.options.max_deviation = max_deviation;
  order.simplify = length_or_none(simplify, "simplify");
  return order;
}

/// The cell of the call or of its meshes, or the finest that all meshes fit. ValueError for a mesh
/// whose file carries another unit.
double shared_cell(const std::vector<const Mesh*>& meshes, std::optional<double> given, Unit unit) {
  double finest = 0;
  for (const Mesh* const mesh : meshes) {
    if (mesh == nullptr) {
      throw py::type_error("meshes: holds None; give Mesh objects");
    }
    if (mesh->input.unit != Unit::none && unit != Unit::none && mesh->input.unit != unit) {
      throw py::value_error(concat("unit: ", mesh->input.path, " is in ",
                                   tool::unit_name(mesh->input.unit),
                                   "; give that unit, or read it with a scale that converts it"));
    }
    finest = std::max(finest, tool::finest_cell(mesh->input));
    if (mesh->cell && given && *mesh->cell != *given) {
      throw py::value_error(concat("cell: ", mesh->input.path, " has the cell ",
                                   tool::shortest(*mesh->cell), " and not ", tool::shortest(*given),
                                   "; meshes share one"));
    }
    given = mesh->cell ? mesh->cell : given;
  }
  return given.value_or(finest);
}

std::unique_ptr<Baked> image_of_tree(tool::AnyBakedTree& any, const Order& order,
                                     const std::string& path) {
  return std::visit(
      [&](auto& tree) {
        tree.unit = order.unit;
        tree.name = std::filesystem::path(path).stem().string().substr(0, bake::kMaxNameSize);
        if (bake::image_size(tree) > 0xFFFFFFFFu) {
          throw tool::UserError(path, "the image would be over 4 GiB; simplify it: --simplify");
        }
        return opened<Baked>(path, bake::image_of(tree));
      },
      any);
}

tool::BakedMesh tree_of(const tool::InputMesh& input, const Order& order) {
  if (!order.simplify) {
    return tool::bake(input, order.options);
  }
  (void)tool::round_mesh(input, order.options);  // refuses a mesh that is too large for the cell
  simplify::Coarsening coarse(input.mesh, *order.options.cell);
  coarse.coarsen(std::max(*order.simplify - input.reading_error(), coarse.rounding()));
  return tool::bake(input, order.options, coarse);
}

std::vector<std::unique_ptr<Baked>> bake_all(const std::vector<const Mesh*>& meshes, Order order) {
  order.options.cell = shared_cell(meshes, order.options.cell, order.unit);
  std::vector<std::unique_ptr<Baked>> baked;
  tool::Warnings warnings;
  {
    const py::gil_scoped_release release;
    for (const Mesh* const mesh : meshes) {
      tool::BakedMesh made = tree_of(mesh->input, order);
      tool::warn_of_mesh(mesh->input, made.defects, order.options, warnings);
      std::visit(
          [&](const auto& tree) { tool::warn_of_place(tree.origin, mesh->input.path, warnings); },
          made.tree);
      baked.push_back(image_of_tree(made.tree, order, mesh->input.path));
    }
  }
  warn(warnings);
  return baked;
}

void add_baked(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(tool::SourceTriangle, number, vertices);
  add_image<Baked>(module, "Baked")
      .def_static("load", [](const py::object& source) { return checked(opened<Baked>(source)); })
      .def_property_readonly("name", [](const Baked& baked) { return text(baked.source()); })
      .def_property_readonly("unit",
                             [](const Baked& baked) { return tool::unit_name(baked.unit()); })
      .def_property_readonly("deviation", &Baked::deviation)
      .def_property_readonly("is_closed", is_closed)
      .def_property_readonly("triangle_count",
                             [](const Baked& baked) { return baked.header().triangle_count; })
      .def_property_readonly(
          "cells", [](const Baked& baked) { return array_of(tool::vertices_of(baked.tree())); })
      .def_property_readonly("source_triangles", [](const Baked& baked) {
        return array_of(tool::source_triangles(baked));
      });
}

}  // namespace

void add_meshes(py::module_& module) {
  py::class_<Mesh>(module, "Mesh")
      .def_property_readonly("name", [](const Mesh& mesh) { return text(mesh.input.path); })
      .def_property_readonly("vertices",
                             [](const Mesh& mesh) { return array_of(mesh.input.mesh.vertices); })
      .def_property_readonly("triangles",
                             [](const Mesh& mesh) { return array_of(mesh.input.mesh.triangles); })
      .def_property_readonly("triangle_count",
                             [](const Mesh& mesh) { return mesh.input.mesh.triangles.size(); })
      .def_readonly("cell", &Mesh::cell)
      .def_property_readonly("finest_cell",
                             [](const Mesh& mesh) { return tool::finest_cell(mesh.input); });
  module.def("mesh_of_file", mesh_of_file);
  module.def("mesh_of_arrays", mesh_of_arrays);
  add_baked(module);
  module.def("bake", [](const std::vector<const Mesh*>& meshes, std::optional<double> cell,
                        const std::optional<std::string>& unit, std::uint32_t leaf_size,
                        std::uint32_t arity, std::uint32_t index_bits,
                        std::optional<double> max_deviation, std::optional<double> simplify) {
    return bake_all(meshes,
                    order_of(cell, unit, leaf_size, arity, index_bits, max_deviation, simplify));
  });
}

}  // namespace flashbvh::python
