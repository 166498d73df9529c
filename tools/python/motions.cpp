// Motions of a body and their first contacts, in batches: the program's functions, in a loop
// without Python's lock.
#include "evaluate/motions.hpp"

#include <algorithm>

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

/// Results with one row per motion.
struct Contacts {
  explicit Contacts(const Shape& shape)
      : outcome(shape), start(shape), end(shape), triangles(shape, {2}), poses(shape, {4, 4}) {}

  void put(std::size_t i, const tool::FoundContact& found, const Pose& pose, double cell) {
    outcome.data[i] = static_cast<std::uint8_t>(found.outcome);
    start.data[i] = tool::share_of(found.from);
    end.data[i] = tool::share_of(found.to);
    put_pair(triangles.data + 2 * i, found.outcome != ContactOutcome::free, found.triangles);
    const auto numbers = tool::pose_numbers(pose, cell);
    double* const matrix = poses.data + 16 * i;
    for (std::size_t row = 0; row < 3; ++row) {
      std::copy_n(numbers.data() + 3 * row, 3, matrix + 4 * row);
      matrix[4 * row + 3] = numbers[9 + row];
    }
    std::fill_n(matrix + 12, 3, 0);
    matrix[15] = 1;
  }

  py::tuple tuple() const {
    return py::make_tuple(outcome.array, start.array, end.array, triangles.array, poses.array);
  }

  Results<std::uint8_t> outcome;
  Results<double> start;
  Results<double> end;
  Results<std::int64_t> triangles;
  Results<double> poses;
};

/// Motions by moves, or to the poses `to` if `moves` is None.
py::tuple first_contact_all(const tool::ImageFile& a, const tool::ImageFile& b,
                            const py::object& from, const py::object& to, const py::object& moves,
                            double within) {
  tool::check_partners(a, b);
  const double cell = a.cell();
  const float cells = tool::cells_in_unit(cell);
  const std::uint32_t distance =
      tool::fine_length(within, cell, kMaxDistance / 2, tool::Rounding::upwards, "within");
  const bool is_between = moves.is_none();
  const Poses starts(from, "start");
  const Poses ends(is_between ? to : from, is_between ? "end" : "start");
  if (ends.shape() != starts.shape()) {
    throw py::value_error("end: has another shape than start; give one of each a motion");
  }
  const std::vector<Move> made = is_between ? std::vector<Move>() : moves_of(moves, cell);
  Contacts contacts(starts.shape());
  {
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Pose start = starts.at(i, cell, cells);
      const BodyMotion motion =
          is_between ? BodyMotion::between(start, ends.at(i, cell, cells))
                     : BodyMotion(start, made.data(), static_cast<std::uint32_t>(made.size()));
      const tool::FoundContact found =
          tool::first_contacts(a, b, motion, distance, false, place_of("motion", i)).front();
      contacts.put(i, found, motion.pose_at(found.to), cell);
    }
  }
  return contacts.tuple();
}

}  // namespace

void add_motions(py::module_& module) {
  module.def("first_contact", first_contact_all);
}

}  // namespace flashbvh::python
