#include "evaluate/points.hpp"

#include <cmath>
#include <cstring>

#include "flashbvh/float.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;

double number_of(std::string_view word, const std::string& place) {
  const auto number = parse_number(word);
  if (!number) {
    throw UserError(place, quoted(word), " is no finite number");
  }
  return *number;
}

std::int32_t cells_of(std::string_view word, double cell, const std::string& place) {
  const double number = number_of(word, place);
  const double cells = std::round(number / cell);
  if (!(std::fabs(cells) <= kMaxTranslation)) {
    throw UserError(place, "the point lies at ", shortest(number), ", the most is ",
                    shortest(kMaxTranslation * cell), " (", kMaxTranslation, " cells)");
  }
  return static_cast<std::int32_t>(cells);
}

/// From three words on.
Point point_of(const Words& words, std::size_t first, double cell, const std::string& place) {
  return {cells_of(words[first], cell, place), cells_of(words[first + 1], cell, place),
          cells_of(words[first + 2], cell, place)};
}

Segment ray_of(const Words& words, double cell, const std::string& place) {
  std::uint64_t cell_bits = 0;
  std::memcpy(&cell_bits, &cell, sizeof cell_bits);
  float number[7];
  for (std::size_t i = 0; i < 7; ++i) {
    number[i] = static_cast<float>(number_of(words[i], place));
  }
  if (number_of(words[6], place) < 0) {  // which may round to 0
    throw UserError(place, "is no ray: the reach is negative; give one from 0");
  }
  const MadeSegment made =
      segment_of({number[0], number[1], number[2]}, {number[3], number[4], number[5]}, number[6],
                 cells_per_unit(cell_bits));
  if (made.status != Status::done) {
    throw UserError(place,
                    "is no ray: the direction is 0, the reach negative, or its end too far off");
  }
  return made.segment;
}

/// read(words, place) of each line that has something in it.
template <class Thing, class Read>
std::vector<Thing> read_lines(const std::string& path, const char* form, const Read& read) {
  const std::string text = read_file(path);
  std::vector<Thing> things;
  for (Lines lines(text); lines.next_content();) {
    things.push_back(read(words_of(lines.line()), concat(path, ":", lines.number())));
  }
  if (things.empty()) {
    throw UserError(path, "is empty; write ", form, " a line");
  }
  return things;
}

}  // namespace

std::vector<Point> read_lattice_points(const std::string& path, double cell) {
  return read_lines<Point>(path, "3 numbers", [&](const Words& words, const std::string& place) {
    if (words.size() != 3) {
      throw UserError(place, "has ", words.size(), " numbers; a point has 3");
    }
    return point_of(words, 0, cell, place);
  });
}

std::vector<Segment> read_lattice_rays(const std::string& path, double cell) {
  return read_lines<Segment>(
      path, "6 or 7 numbers", [&](const Words& words, const std::string& place) -> Segment {
        if (words.size() == 7) {
          return ray_of(words, cell, place);
        }
        if (words.size() != 6) {
          throw UserError(place, "has ", words.size(),
                          " numbers; a ray has 6, from and to, or 7: origin, direction, reach");
        }
        return {point_of(words, 0, cell, place), point_of(words, 3, cell, place)};
      });
}

}  // namespace flashbvh::tool
