#include "mesh/formats.hpp"

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

std::string warn_of_cut_line(std::string_view text) {
  const bool ended = text.back() == '\n' || text.back() == '\r';
  return ended ? "" : "the last line has no end: the file may be truncated";
}

void append_coordinate(std::string& bytes, std::string_view word, const std::string& file,
                       std::size_t line) {
  if (!parse_number(word)) {
    throw UserError(at_line(file, line), quoted(word),
                    " is no finite number, which a coordinate must be; repair the mesh");
  }
  bytes += " ";
  bytes += word;
}

}  // namespace flashbvh::tool
