#include "evaluate/motions.hpp"

#include <array>
#include <cmath>

#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::size_t kMoveNumbers = 10;
constexpr double kDegrees = 360;
/// The limit keeps turns within 32 bits.
constexpr double kTooManyTurns = 8;

/// A pose, or a translation alone.
Pose pose_in(std::string_view text, double cell, const std::string& place) {
  const std::size_t count = words_of(text).size();
  if (count != 3 && count != 12) {
    throw UserError(place, "has ", count,
                    " numbers; write 12, the rotation row by row and the translation, or 3, the "
                    "translation alone");
  }
  const std::string whole = (count == 3 ? "1 0 0 0 1 0 0 0 1 " : "") + std::string(text);
  return read_lattice_pose(whole, cell, place, false);
}

/// "2^19 cells, 5242.88".
std::string farthest(double cell) {
  constexpr std::int32_t cells = kMaxFrameTranslation / kFrameCell;
  return concat("2^", std::ilogb(cells), " cells, ", significant(cells * cell, 6));
}

std::int32_t frame_length(double length, double cell, const std::string& place) {
  const double parts = std::round(length / cell * kFrameCell);
  if (!(std::fabs(parts) <= kMaxFrameTranslation)) {
    throw UserError(place, "has the length ", shortest(length), "; the most is ", farthest(cell));
  }
  return static_cast<std::int32_t>(parts);
}

Move move_of(std::string_view line, double cell, const std::string& place) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() != kMoveNumbers) {
    throw UserError(place, "has ", words.size(),
                    " numbers; a move has 10: a point of the axis, its direction, degrees, the "
                    "travel");
  }
  std::array<double, kMoveNumbers> n{};
  for (std::size_t i = 0; i < kMoveNumbers; ++i) {
    n[i] = number_of(words[i], place);
  }
  const double turns = n[6] / kDegrees;
  const double turn = std::round(turns * kFullTurn);
  if (!(std::fabs(turn) < kTooManyTurns * kFullTurn)) {
    throw UserError(place, "turns ", shortest(turns), " times; the most is less than 8");
  }
  const double length = std::hypot(n[3], n[4], n[5]);
  if (turn != 0 && !(length > 0 && std::isfinite(length))) {
    throw UserError(place, "turns about an axis without a direction; give one of another length");
  }
  Move made = {};
  made.turn = static_cast<std::int32_t>(turn);
  for (std::size_t i = 0; i < 3; ++i) {
    made.point[i] = frame_length(n[i], cell, place);
    made.travel[i] = frame_length(n[7 + i], cell, place);
    if (turn != 0) {
      made.axis[i] = static_cast<std::int32_t>(std::round(n[3 + i] / length * kRotationOne));
    }
  }
  return made;
}

template <class Mesh>
std::vector<FoundContact> contacts_of(const Mesh& a, const Mesh& b, const BodyMotion& motion,
                                      FineLength within, bool all) {
  std::vector<FoundContact> found;
  BasicFirstContact<Mesh> query(a, b, motion, within);
  do {
    query.pass();
    const auto answer = query.run(UINT32_MAX);
    found.push_back({{answer.status,
                      answer.outcome,
                      {answer.triangles.a, answer.triangles.b},
                      answer.from,
                      answer.to},
                     query.close_distance()});
  } while (all && found.back().status == Status::done &&
           found.back().outcome == ContactOutcome::close);
  return found;
}

}  // namespace

Pose read_pose_argument(const std::string& given, double cell, const std::string& option) {
  const std::vector<std::string_view> words = words_of(given);
  if (words.empty() || parse_number(words[0])) {
    return pose_in(given, cell, option);
  }
  const auto poses = read_lines<Pose>(
      given, "has no pose; write 12 numbers, or 3, in",
      [&](std::string_view line, const std::string& place) { return pose_in(line, cell, place); });
  if (poses.size() != 1) {
    throw UserError(given, "has ", poses.size(), " poses; ", option, " takes one");
  }
  return poses[0];
}

std::vector<Move> read_moves(const std::string& path, double cell) {
  auto moves = read_lines<Move>(
      path, "has no moves; write 10 numbers",
      [&](std::string_view line, const std::string& place) { return move_of(line, cell, place); });
  if (moves.size() > kMostMoves) {
    throw UserError(path, "has ", moves.size(), " moves; a motion has at most ", kMostMoves);
  }
  return moves;
}

std::vector<FoundContact> first_contacts(const ImageFile& a, const ImageFile& b,
                                         const BodyMotion& motion, FineLength within, bool all,
                                         const std::string& place) {
  auto found = query_post<std::vector<FoundContact>>(
      [&](const auto& mesh_a, const auto& mesh_b) {
        return contacts_of(mesh_a, mesh_b, motion, within, all);
      },
      a.tree(), b.tree());
  const Status status = found.value().back().status;
  if (status == Status::motion_out_of_range) {
    throw UserError(place, "may take B farther than ", farthest(a.cell()),
                    ", from A's origin; cut the motion, or bake with a larger --cell, or draw the "
                    "meshes nearer to their origins");
  }
  if (status != Status::done) {
    throw UserError(place, "can't be answered: ", status_name(status));
  }
  return *std::move(found);
}

const char* outcome_name(ContactOutcome outcome) {
  constexpr const char* kNames[] = {"free", "contact", "close"};
  return kNames[static_cast<std::size_t>(outcome)];
}

}  // namespace flashbvh::tool
