// Queries of baked meshes for batches of poses, rays and points: the library's queries, in a loop
// without Python's lock.
#include <cmath>

#include "evaluate/queries.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/solid.hpp"
#include "python/bindings.hpp"
#include "python/mesh.hpp"
#include "python/poses.hpp"

namespace flashbvh::python {
namespace {

const Argument kOrigins = {"origins", {3}};
const Argument kDirections = {"directions", {3}};
const Argument kLength = {"length", {}};
const Argument kPoints = {"points", {3}};

void check_done(Status status, const char* argument, std::size_t number) {
  if (status != Status::done) {
    throw tool::UserError(place_of(argument, number), "can't be answered: ", status_name(status));
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
  py::array_t<bool> found(poses.shape());
  bool* const to = found.mutable_data();
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose, std::size_t i) {
                  const flashbvh::Answer answer = query(mesh_a, mesh_b, pose);
                  check_done(answer.status, "poses", i);
                  to[i] = answer.yes;
                });
  return found;
}

py::array_t<bool> intersects_all(const Baked& a, const Baked& b, const py::object& poses) {
  return answers(a, b, poses, [](const auto& mesh_a, const auto& mesh_b, const Pose& pose) {
    return flashbvh::intersects(mesh_a, mesh_b, pose);
  });
}

py::array_t<bool> solids_intersect_all(const Baked& a, const Baked& b, const py::object& poses) {
  for (const Baked* const baked : {&a, &b}) {
    if ((baked->header().flags & kImageIsClosed) == 0) {
      throw tool::UserError(baked->path(),
                            "is no closed surface and has no inside; `flashbvh check` "
                            "says where it is open");
    }
  }
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

double length_of(std::int64_t fine, double cell) {
  return static_cast<double>(fine) / kFineOne * cell;
}

void put_point(double* to, const FinePoint& point, double cell) {
  to[0] = length_of(point.x, cell);
  to[1] = length_of(point.y, cell);
  to[2] = length_of(point.z, cell);
}

/// Result arrays with one row per pose.
struct Distances {
  explicit Distances(const Shape& shape)
      : lower(shape),
        upper(shape),
        point_a(with(shape, 3)),
        point_b(with(shape, 3)),
        triangles(with(shape, 2)) {}

  py::array_t<double> lower;
  py::array_t<double> upper;
  py::array_t<double> point_a;
  py::array_t<double> point_b;
  py::array_t<std::int64_t> triangles;
};

/// The memory of Distances, written without Python's lock.
struct DistanceRows {
  explicit DistanceRows(Distances& distances)
      : lower(distances.lower.mutable_data()),
        upper(distances.upper.mutable_data()),
        point_a(distances.point_a.mutable_data()),
        point_b(distances.point_b.mutable_data()),
        triangles(distances.triangles.mutable_data()) {}

  template <class Index>
  void put(std::size_t i, const Clearance<Index>& found, double cell) const {
    const double nan = std::nan("");
    lower[i] = length_of(found.lower, cell);
    upper[i] = found.upper == UINT32_MAX ? HUGE_VAL : length_of(found.upper, cell);
    const bool known = found.in_range;
    put_point(point_a + 3 * i, found.point_a, known ? cell : nan);
    put_point(point_b + 3 * i, found.point_b, known ? cell : nan);
    triangles[2 * i] = known ? std::int64_t{found.triangles.a} : -1;
    triangles[2 * i + 1] = known ? std::int64_t{found.triangles.b} : -1;
  }

  double* lower;
  double* upper;
  double* point_a;
  double* point_b;
  std::int64_t* triangles;
};

/// `is_motion`: each pose starts with the last nearest pair as a hint, which saves visits if poses
/// are close together and costs some if not.
py::tuple distance_all(const Baked& a, const Baked& b, const py::object& given, bool is_motion) {
  const Poses poses(given);
  Distances distances(poses.shape());
  const DistanceRows to(distances);
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
        to.put(i, found, cell);
      });
  return py::make_tuple(distances.lower, distances.upper, distances.point_a, distances.point_b,
                        distances.triangles);
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
  py::array_t<std::int64_t> pairs(with(poses.shape(), 2));
  std::int64_t* const to = pairs.mutable_data();
  for_each_pose(a, b, poses,
                [&](const auto& mesh_a, const auto& mesh_b, const Pose& pose, std::size_t i) {
                  using Index = typename std::decay_t<decltype(mesh_a)>::Index;
                  TrianglePair<Index> pair{};
                  const flashbvh::Answer answer = flashbvh::first_pair(mesh_a, mesh_b, pose, pair);
                  check_done(answer.status, "poses", i);
                  to[2 * i] = answer.yes ? std::int64_t{pair.a} : -1;
                  to[2 * i + 1] = answer.yes ? std::int64_t{pair.b} : -1;
                });
  return pairs;
}

void get_floats(const double* from, float (&to)[3]) {
  for (std::size_t i = 0; i < 3; ++i) {
    to[i] = static_cast<float>(from[i]);
  }
}

/// Rays as firmware gets them, as floats.
struct Rays {
  Doubles origins;
  Doubles directions;
  Doubles length;

  Rays(const py::object& from, const py::object& along, const py::object& reach)
      : origins(numbers(from, kOrigins)),
        directions(numbers(along, kDirections)),
        length(numbers(reach, kLength)) {
    if (outer_shape(origins, kOrigins) != outer_shape(directions, kDirections)) {
      throw py::value_error("directions: has another shape than origins; give one of each a ray");
    }
    if (length.ndim() != 0 && outer_shape(length, kLength) != outer_shape(origins, kOrigins)) {
      throw py::value_error("length: has another shape than origins; give a number, or one a ray");
    }
  }
};

/// Returns arrays: hit or not, distance, triangle.
py::tuple hits_of(const Baked& baked, const py::object& from, const py::object& along,
                  const py::object& reach) {
  const Rays rays(from, along, reach);
  const Shape shape = outer_shape(rays.origins, kOrigins);
  const std::size_t size = count_of(rays.origins, kOrigins);
  py::array_t<bool> hit(shape);
  py::array_t<double> distance(shape);
  py::array_t<std::int64_t> triangle(shape);
  const auto cast = [&, origins = rays.origins.data(), directions = rays.directions.data(),
                     lengths = rays.length.data(), one_length = rays.length.ndim() == 0,
                     hits = hit.mutable_data(), distances = distance.mutable_data(),
                     triangles = triangle.mutable_data(), cell = baked.cell()](const auto& mesh) {
    for (std::size_t i = 0; i < size; ++i) {
      float origin[3];
      float direction[3];
      get_floats(origins + 3 * i, origin);
      get_floats(directions + 3 * i, direction);
      const MadeSegment made =
          segment_of(origin, direction, static_cast<float>(lengths[one_length ? 0 : i]),
                     cells_per_unit(mesh.cell_bits));
      const auto answer = nearest_hit(mesh, made.segment);
      if (made.status != Status::done || answer.status != Status::done) {
        throw tool::UserError(place_of("rays", i),
                              "is no ray: the direction is 0, the length negative, or its end too "
                              "far off");
      }
      hits[i] = answer.yes;
      distances[i] =
          answer.yes ? length_of(distance_along(made.segment, answer.hit.along), cell) : HUGE_VAL;
      triangles[i] = answer.yes ? std::int64_t{answer.hit.triangle} : -1;
    }
    return true;
  };
  {
    const py::gil_scoped_release release;
    (void)tool::query_post_mesh<bool>(baked, cast);
  }
  return py::make_tuple(hit, distance, triangle);
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
  const Doubles points = numbers(given, kPoints);
  const std::size_t size = count_of(points, kPoints);
  py::array_t<bool> found(outer_shape(points, kPoints));
  const auto look = [&, from = points.data(), to = found.mutable_data(),
                     cell = baked.cell()](const auto& mesh) {
    if (!mesh.is_closed) {
      throw tool::UserError(baked.path(),
                            "is no closed surface and has no inside; `flashbvh check` says where "
                            "it is open");
    }
    for (std::size_t i = 0; i < size; ++i) {
      const PointAnswer answer = inside(mesh, point_of(from + 3 * i, cell, i));
      check_done(answer.status, "points", i);
      to[i] = answer.side != PointSide::outside;
    }
    return true;
  };
  const py::gil_scoped_release release;
  (void)tool::query_post_mesh<bool>(baked, look);
  return found;
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
