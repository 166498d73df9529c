// Queries of baked meshes for batches of poses, rays and points: the library's queries, in a loop
// without Python's lock.
#include <cmath>

#include "cli/json.hpp"
#include "evaluate/queries.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/solid.hpp"
#include "image/fine_length.hpp"
#include "python/bindings.hpp"
#include "python/images.hpp"
#include "python/poses.hpp"

namespace flashbvh::python {
namespace {

void check_done(Status status, const char* argument, std::size_t number) {
  if (status != Status::done) {
    throw tool::UserError(place_of(argument, number), "can't be answered: ", status_name(status));
  }
}

void check_closed(const Baked& baked) {
  if (!is_closed(baked)) {
    throw tool::UserError(baked.path(),
                          "is no closed surface and has no inside; `flashbvh check` says where it "
                          "is open");
  }
}

/// Calls query(mesh_a, mesh_b, pose, number) for each pose, without Python's lock.
template <class Query>
void for_each_pose(const Baked& a, const Baked& b, const Poses& poses, const Query& query) {
  tool::check_partners(a, b);
  const double cell = a.cell();
  const py::gil_scoped_release release;
  (void)tool::query_post<bool>(
      [&](const auto& mesh_a, const auto& mesh_b) {
        const float cells = cells_per_unit(mesh_a.cell_bits);
        for (std::size_t i = 0; i < poses.size(); ++i) {
          query(mesh_a, mesh_b, poses.at(i, cell, cells), i);
        }
        return true;
      },
      a.tree(), b.tree());
}

/// Calls query(mesh_a, mesh_b, pose), which returns an Answer, for each pose.
template <class Query>
py::array answers(const Baked& a, const Baked& b, const py::object& given, const Query& query) {
  const Poses poses(given);
  const Results<bool> found(poses.shape());
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose, std::size_t i) {
                  const flashbvh::Answer answer = query(mesh_a, mesh_b, pose);
                  check_done(answer.status, "poses", i);
                  found.data[i] = answer.yes;
                });
  return found.array;
}

py::array intersects_all(const Baked& a, const Baked& b, const py::object& poses) {
  return answers(a, b, poses, [](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    return flashbvh::intersects(mesh_a, mesh_b, pose);
  });
}

py::array solids_intersect_all(const Baked& a, const Baked& b, const py::object& poses) {
  check_closed(a);
  check_closed(b);
  return answers(a, b, poses, [](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    return flashbvh::solids_intersect(mesh_a, mesh_b, pose);
  });
}

py::array closer_than_all(const Baked& a, const Baked& b, const py::object& poses, double length) {
  if (!(length >= 0)) {
    throw py::value_error("length: is no length; give a number from 0");
  }
  const FineLength fine = tool::fine_length_rounded_up(length, a.cell());
  return answers(a, b, poses, [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    return flashbvh::closer_than(mesh_a, mesh_b, pose, fine);
  });
}

std::array<double, 3> point_of(const FinePoint& point, double cell) {
  return {tool::unit_length(point.x, cell), tool::unit_length(point.y, cell),
          tool::unit_length(point.z, cell)};
}

/// The distance at a pose.
struct DistanceRow {
  double lower;
  double upper;
  std::array<double, 3> point_a;
  std::array<double, 3> point_b;
  std::array<std::int64_t, 2> triangles;
};

template <class Index>
DistanceRow row_of(const Clearance<Index>& found, double cell) {
  const double cell_or_nan = found.in_range ? cell : std::nan("");
  return {tool::unit_length(found.lower, cell),
          found.upper == UINT32_MAX ? HUGE_VAL : tool::unit_length(found.upper, cell),
          point_of(found.point_a, cell_or_nan), point_of(found.point_b, cell_or_nan),
          ids_of(found.triangles, found.in_range)};
}

/// `is_motion`: each pose starts with the last nearest pair as a hint, which saves visits if poses
/// are close together and costs some if not.
py::array distance_all(const Baked& a, const Baked& b, const py::object& given, bool is_motion) {
  const Poses poses(given);
  const Results<DistanceRow> distances(poses.shape());
  const double cell = a.cell();
  Witness<std::uint32_t> hint;
  for_each_pose(
      a, b, poses, [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose, std::size_t i) {
        using Index = typename std::decay_t<decltype(mesh_a)>::Index;
        const Witness<Index> last = {static_cast<Index>(hint.a), static_cast<Index>(hint.b)};
        const Clearance<Index> found = flashbvh::distance(mesh_a, mesh_b, pose, last);
        check_done(found.status, "poses", i);
        if (is_motion && found.in_range) {
          hint = {found.witness.a, found.witness.b};
        }
        distances.data[i] = row_of(found, cell);
      });
  return distances.array;
}

py::array pairs_at(const Baked& a, const Baked& b, const py::object& pose) {
  const Poses poses(pose);
  if (!poses.shape().empty()) {
    throw py::value_error("pose: is a batch; give one matrix, (4, 4)");
  }
  std::vector<std::array<std::int64_t, 2>> found;
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& at, std::size_t i) {
                  check_done(flashbvh::for_each_pair(mesh_a, mesh_b, at,
                                                     [&](const auto& pair) {
                                                       found.push_back(ids_of(pair, true));
                                                       return true;
                                                     }),
                             "poses", i);
                });
  return array_of(found);
}

py::array first_pair_all(const Baked& a, const Baked& b, const py::object& given) {
  const Poses poses(given);
  const Results<std::array<std::int64_t, 2>> pairs(poses.shape());
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose, std::size_t i) {
                  using Index = typename std::decay_t<decltype(mesh_a)>::Index;
                  TrianglePair<Index> pair{};
                  const flashbvh::Answer answer = flashbvh::first_pair(mesh_a, mesh_b, pose, pair);
                  check_done(answer.status, "poses", i);
                  pairs.data[i] = ids_of(pair, answer.yes);
                });
  return pairs.array;
}

/// Rays as firmware gets them, as floats.
struct Rays {
  Numbers origins;
  Numbers directions;
  Numbers length;

  Rays(const py::object& from, const py::object& along, const py::object& reach)
      : origins(numbers(from, {"origins", {3}})),
        directions(numbers(along, {"directions", {3}})),
        length(numbers(reach, {"length", {}})) {
    if (origins.shape != directions.shape) {
      throw py::value_error("directions: has another shape than origins; give one of each a ray");
    }
    if (!length.shape.empty() && length.shape != origins.shape) {
      throw py::value_error("length: has another shape than origins; give a number, or one a ray");
    }
  }

  /// Ray number `i` on the lattice of a mesh.
  MadeSegment at(std::size_t i, float cells) const {
    float origin[3];
    float direction[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin[axis] = static_cast<float>(origins.data[3 * i + axis]);
      direction[axis] = static_cast<float>(directions.data[3 * i + axis]);
    }
    const double reach = length.data[length.shape.empty() ? 0 : i];
    return segment_of(origin, direction, static_cast<float>(reach), cells);
  }
};

/// The first hit of a ray.
struct HitRow {
  bool hit;
  double distance;
  std::int64_t triangle;
};

py::array hits_of(const Baked& baked, const py::object& from, const py::object& along,
                  const py::object& reach) {
  const Rays rays(from, along, reach);
  const Results<HitRow> hits(rays.origins.shape);
  const auto cast = [&](const auto& mesh) {
    for (std::size_t i = 0; i < rays.origins.count; ++i) {
      const MadeSegment made = rays.at(i, cells_per_unit(mesh.cell_bits));
      const auto answer = nearest_hit(mesh, made.segment);
      if (made.status != Status::done || answer.status != Status::done) {
        throw tool::UserError(place_of("rays", i),
                              "is no ray: the direction is 0, the length negative, or its end too "
                              "far off");
      }
      hits.data[i] = {false, HUGE_VAL, -1};
      if (answer.yes) {
        const std::uint32_t cells = distance_along(made.segment, answer.hit.along);
        hits.data[i] = {true, tool::unit_length(cells, baked.cell()), answer.hit.triangle};
      }
    }
    return true;
  };
  {
    const py::gil_scoped_release release;
    (void)tool::query_post_mesh<bool>(baked, cast);
  }
  return hits.array;
}

/// A point in cells, rounded as in `flashbvh inside`.
Point point_of(const double* from, double cell, std::size_t number) {
  std::int32_t cells[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double rounded = std::round(from[i] / cell);
    if (!(std::fabs(rounded) <= kMaxTranslation)) {
      throw tool::UserError(place_of("points", number), "the point lies at ",
                            tool::shortest(from[i]), ", the most is ",
                            tool::shortest(kMaxTranslation * cell), " (", kMaxTranslation,
                            " cells)");
    }
    cells[i] = static_cast<std::int32_t>(rounded);
  }
  return {cells[0], cells[1], cells[2]};
}

py::array inside_all(const Baked& baked, const py::object& given) {
  const Numbers points = numbers(given, {"points", {3}});
  const Results<bool> found(points.shape);
  check_closed(baked);
  const auto look = [&](const auto& mesh) {
    for (std::size_t i = 0; i < points.count; ++i) {
      const PointAnswer answer = inside(mesh, point_of(points.data + 3 * i, baked.cell(), i));
      check_done(answer.status, "points", i);
      found.data[i] = answer.side != PointSide::outside;
    }
    return true;
  };
  {
    const py::gil_scoped_release release;
    (void)tool::query_post_mesh<bool>(baked, look);
  }
  return found.array;
}

}  // namespace

void add_mesh_queries(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(DistanceRow, lower, upper, point_a, point_b, triangles);
  PYBIND11_NUMPY_DTYPE(HitRow, hit, distance, triangle);
  module.def("intersects", intersects_all);
  module.def("solids_intersect", solids_intersect_all);
  module.def("closer_than", closer_than_all);
  module.def("distance", distance_all);
  module.def("first_pair", first_pair_all);
  module.def("pairs", pairs_at);
  module.def("nearest_hit", hits_of);
  module.def("inside", inside_all);
}

}  // namespace flashbvh::python
