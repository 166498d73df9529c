// Motions of a body and their first contacts, in batches: the program's functions, in a loop
// without Python's lock.
#include "evaluate/motions.hpp"

#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "python/bindings.hpp"
#include "python/poses.hpp"
#include "robot/kinematics.hpp"

namespace flashbvh::python {
namespace {

using tool::concat;

/// One move per row: a point, a direction, radians, the travel.
std::vector<Move> moves_of(const py::object& given, double cell) {
  const Numbers array = rows(given, {"moves", {10}});
  if (array.count > kMostMoves) {
    throw py::value_error(concat("moves: has ", array.count, " rows; give at most ", kMostMoves));
  }
  std::vector<Move> moves;
  for (std::size_t i = 0; i < array.count; ++i) {
    const double* const n = array.data + 10 * i;
    moves.push_back(tool::lattice_move(
        {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6] / tool::kTurn, {n[7], n[8], n[9]}}, cell,
        place_of("moves", i)));
  }
  return moves;
}

/// The first contact of a motion.
struct ContactRow {
  std::uint8_t outcome;
  double start;
  double end;
  std::array<std::int64_t, 2> triangles;
  std::array<std::array<double, 4>, 4> pose;
};

std::array<std::array<double, 4>, 4> matrix_of(const Pose& pose, double cell) {
  const auto [a, b, c, d, e, f, g, h, i, x, y, z] = tool::pose_numbers(pose, cell);
  return {{{a, b, c, x}, {d, e, f, y}, {g, h, i, z}, {0, 0, 0, 1}}};
}

/// Motions by moves, or to the poses `to` if `moves` is None.
py::array first_contact_all(const tool::ImageFile& a, const tool::ImageFile& b,
                            const py::object& from, const py::object& to, const py::object& moves,
                            double within) {
  tool::check_partners(a, b);
  const double cell = a.cell();
  const float cells = tool::cells_in_unit(cell);
  const FineLength distance = tool::fine_length(within, cell, kMaxMotionDistance, "within");
  const bool is_between = moves.is_none();
  const Poses starts(from, "start");
  const Poses ends(is_between ? to : from, is_between ? "end" : "start");
  if (ends.shape() != starts.shape()) {
    throw py::value_error("end: has another shape than start; give one of each a motion");
  }
  const std::vector<Move> made = is_between ? std::vector<Move>() : moves_of(moves, cell);
  const Results<ContactRow> contacts(starts.shape());
  {
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Pose start = starts.at(i, cell, cells);
      const BodyMotion motion =
          is_between ? BodyMotion::between(start, ends.at(i, cell, cells))
                     : BodyMotion(start, made.data(), static_cast<std::uint32_t>(made.size()));
      const tool::FoundContact found =
          tool::first_contacts(a, b, motion, distance, false, place_of("motion", i)).front();
      contacts.data[i] = {static_cast<std::uint8_t>(found.outcome), tool::share_of(found.from),
                          tool::share_of(found.to),
                          ids_of(found.triangles, found.outcome != ContactOutcome::free),
                          matrix_of(motion.pose_at(found.to), cell)};
    }
  }
  return contacts.array;
}

}  // namespace

void add_motions(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ContactRow, outcome, start, end, triangles, pose);
  module.def("first_contact", first_contact_all);
}

}  // namespace flashbvh::python
