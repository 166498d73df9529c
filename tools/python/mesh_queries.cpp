// Queries of baked meshes for batches of poses, rays and points: the library's queries, in a loop
// without Python's lock.
#include <cmath>

#include "cli/json.hpp"
#include "evaluate/queries.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/solid.hpp"
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
py::array_t<bool> answers(const Baked& a, const Baked& b, const py::object& given,
                          const Query& query) {
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

py::array_t<bool> intersects_all(const Baked& a, const Baked& b, const py::object& poses) {
  return answers(a, b, poses, [](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    return flashbvh::intersects(mesh_a, mesh_b, pose);
  });
}

py::array_t<bool> solids_intersect_all(const Baked& a, const Baked& b, const py::object& poses) {
  check_closed(a);
  check_closed(b);
  return answers(a, b, poses, [](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    return flashbvh::solids_intersect(mesh_a, mesh_b, pose);
  });
}

py::array_t<bool> closer_than_all(const Baked& a, const Baked& b, const py::object& poses,
                                  double length) {
  if (!(length >= 0)) {
    throw py::value_error("length: is no length; give a number from 0");
  }
  return answers(a, b, poses, [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    const std::uint32_t fine =
        fine_distance(static_cast<float>(length), cells_per_unit(mesh_a.cell_bits));
    return flashbvh::closer_than(mesh_a, mesh_b, pose, fine);
  });
}

void put_point(double* to, const FinePoint& point, double cell) {
  to[0] = tool::unit_length(point.x, cell);
  to[1] = tool::unit_length(point.y, cell);
  to[2] = tool::unit_length(point.z, cell);
}

/// Results with one row per pose.
struct Distances {
  explicit Distances(const Shape& shape)
      : lower(shape),
        upper(shape),
        point_a(shape, {3}),
        point_b(shape, {3}),
        triangles(shape, {2}) {}

  template <class Index>
  void put(std::size_t i, const Clearance<Index>& found, double cell) {
    lower.data[i] = tool::unit_length(found.lower, cell);
    upper.data[i] = found.upper == UINT32_MAX ? HUGE_VAL : tool::unit_length(found.upper, cell);
    const double cell_or_nan = found.in_range ? cell : std::nan("");
    put_point(point_a.data + 3 * i, found.point_a, cell_or_nan);
    put_point(point_b.data + 3 * i, found.point_b, cell_or_nan);
    put_pair(triangles.data + 2 * i, found.in_range, found.triangles);
  }

  Results<double> lower;
  Results<double> upper;
  Results<double> point_a;
  Results<double> point_b;
  Results<std::int64_t> triangles;
};

/// `is_motion`: each pose starts with the last nearest pair as a hint, which saves visits if poses
/// are close together and costs some if not.
py::tuple distance_all(const Baked& a, const Baked& b, const py::object& given, bool is_motion) {
  const Poses poses(given);
  Distances distances(poses.shape());
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
        distances.put(i, found, cell);
      });
  return py::make_tuple(distances.lower.array, distances.upper.array, distances.point_a.array,
                        distances.point_b.array, distances.triangles.array);
}

py::array_t<std::int64_t> pairs_at(const Baked& a, const Baked& b, const py::object& pose) {
  const Poses poses(pose);
  if (!poses.shape().empty()) {
    throw py::value_error("pose: is a batch; give one matrix, (4, 4)");
  }
  std::vector<std::int64_t> found;
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& at, std::size_t i) {
                  check_done(flashbvh::for_each_pair(mesh_a, mesh_b, at,
                                                     [&](const auto& pair) {
                                                       found.push_back(pair.a);
                                                       found.push_back(pair.b);
                                                       return true;
                                                     }),
                             "poses", i);
                });
  py::array_t<std::int64_t> pairs({static_cast<py::ssize_t>(found.size() / 2), py::ssize_t{2}});
  std::copy(found.begin(), found.end(), pairs.mutable_data());
  return pairs;
}

py::array_t<std::int64_t> first_pair_all(const Baked& a, const Baked& b, const py::object& given) {
  const Poses poses(given);
  const Results<std::int64_t> pairs(poses.shape(), {2});
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose, std::size_t i) {
                  using Index = typename std::decay_t<decltype(mesh_a)>::Index;
                  TrianglePair<Index> pair{};
                  const flashbvh::Answer answer = flashbvh::first_pair(mesh_a, mesh_b, pose, pair);
                  check_done(answer.status, "poses", i);
                  put_pair(pairs.data + 2 * i, answer.yes, pair);
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

/// Returns arrays: hit or not, distance, triangle.
py::tuple hits_of(const Baked& baked, const py::object& from, const py::object& along,
                  const py::object& reach) {
  const Rays rays(from, along, reach);
  const Results<bool> hit(rays.origins.shape);
  const Results<double> distance(rays.origins.shape);
  const Results<std::int64_t> triangle(rays.origins.shape);
  const auto cast = [&](const auto& mesh) {
    for (std::size_t i = 0; i < rays.origins.count; ++i) {
      const MadeSegment made = rays.at(i, cells_per_unit(mesh.cell_bits));
      const auto answer = nearest_hit(mesh, made.segment);
      if (made.status != Status::done || answer.status != Status::done) {
        throw tool::UserError(place_of("rays", i),
                              "is no ray: the direction is 0, the length negative, or its end too "
                              "far off");
      }
      hit.data[i] = answer.yes;
      distance.data[i] =
          answer.yes
              ? tool::unit_length(distance_along(made.segment, answer.hit.along), baked.cell())
              : HUGE_VAL;
      triangle.data[i] = answer.yes ? std::int64_t{answer.hit.triangle} : -1;
    }
    return true;
  };
  {
    const py::gil_scoped_release release;
    (void)tool::query_post_mesh<bool>(baked, cast);
  }
  return py::make_tuple(hit.array, distance.array, triangle.array);
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

py::array_t<bool> inside_all(const Baked& baked, const py::object& given) {
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
