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
  const Doubles array = rows(given, {"moves", {10}});
  const auto count = static_cast<std::size_t>(array.shape(0));
  if (count > kMostMoves) {
    throw py::value_error(concat("moves: has ", count, " rows; give at most ", kMostMoves));
  }
  std::vector<Move> moves;
  for (std::size_t i = 0; i < count; ++i) {
    const double* const n = array.data() + 10 * i;
    moves.push_back(tool::lattice_move(
        {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6] / tool::kTurn, {n[7], n[8], n[9]}}, cell,
        place_of("moves", i)));
  }
  return moves;
}

/// Result arrays with one row per motion.
struct Contacts {
  explicit Contacts(const Shape& shape)
      : outcome(shape),
        start(shape),
        end(shape),
        triangles(with(shape, 2)),
        poses(with(with(shape, 4), 4)) {}

  py::tuple tuple() const { return py::make_tuple(outcome, start, end, triangles, poses); }

  py::array_t<std::uint8_t> outcome;
  py::array_t<double> start;
  py::array_t<double> end;
  py::array_t<std::int64_t> triangles;
  py::array_t<double> poses;
};

/// The memory of Contacts, written without Python's lock.
struct ContactRows {
  explicit ContactRows(Contacts& contacts)
      : outcome(contacts.outcome.mutable_data()),
        start(contacts.start.mutable_data()),
        end(contacts.end.mutable_data()),
        triangles(contacts.triangles.mutable_data()),
        poses(contacts.poses.mutable_data()) {}

  void put(std::size_t i, const tool::FoundContact& found, const Pose& pose, double cell) const {
    const bool is_free = found.outcome == ContactOutcome::free;
    outcome[i] = static_cast<std::uint8_t>(found.outcome);
    start[i] = tool::share_of(found.from);
    end[i] = tool::share_of(found.to);
    triangles[2 * i] = is_free ? -1 : std::int64_t{found.triangles.a};
    triangles[2 * i + 1] = is_free ? -1 : std::int64_t{found.triangles.b};
    const auto numbers = tool::pose_numbers(pose, cell);
    double* const matrix = poses + 16 * i;
    for (std::size_t entry = 0; entry < 16; ++entry) {
      const std::size_t row = entry / 4;
      const std::size_t column = entry % 4;
      matrix[entry] = row == 3      ? (column == 3 ? 1 : 0)
                      : column == 3 ? numbers[9 + row]
                                    : numbers[3 * row + column];
    }
  }

  std::uint8_t* outcome;
  double* start;
  double* end;
  std::int64_t* triangles;
  double* poses;
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
  const ContactRows rows(contacts);
  {
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Pose start = starts.at(i, cell, cells);
      const BodyMotion motion =
          is_between ? BodyMotion::between(start, ends.at(i, cell, cells))
                     : BodyMotion(start, made.data(), static_cast<std::uint32_t>(made.size()));
      const tool::FoundContact found =
          tool::first_contacts(a, b, motion, distance, false, place_of("motion", i)).front();
      rows.put(i, found, motion.pose_at(found.to), cell);
    }
  }
  return contacts.tuple();
}

}  // namespace

void add_motions(py::module_& module) {
  module.def("first_contact", first_contact_all);
}

}  // namespace flashbvh::python
