#include "mesh/formats.hpp"

namespace flashbvh::tool {

void warn_of_cut_line(std::string_view text, FileMesh& mesh) {
  if (text.back() != '\n' && text.back() != '\r') {
    mesh.warnings.emplace_back("the last line has no end: the file may be truncated");
  }
}

}  // namespace flashbvh::tool
