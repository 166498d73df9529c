#include "mesh/ply_header.hpp"

#include <algorithm>
#include <array>

#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;
using Encoding = PlyHeader::Encoding;

constexpr std::array<PlyType, 8> kTypes = {{{"char", "int8", 1, PlyType::is_signed},
                                            {"uchar", "uint8", 1, PlyType::is_unsigned},
                                            {"short", "int16", 2, PlyType::is_signed},
                                            {"ushort", "uint16", 2, PlyType::is_unsigned},
                                            {"int", "int32", 4, PlyType::is_signed},
                                            {"uint", "uint32", 4, PlyType::is_unsigned},
                                            {"float", "float32", 4, PlyType::is_floating},
                                            {"double", "float64", 8, PlyType::is_floating}}};

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  PlyHeader read() {
    if (!lines_.next() || words_of(lines_.line()) != Words{"ply"}) {
      throw UserError(file_, "is no PLY file: it does not begin with 'ply'");
    }
    while (lines_.next()) {
      const Words words = words_of(lines_.line());
      if (!words.empty() && words[0] == "end_header") {
        return finish();
      }
      line(words);
    }
    refuse("the file ends in its header");
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(at_line(file_, lines_.number()), what..., "; export the mesh again");
  }

  PlyHeader finish() {
    if (!header_.encoding) {
      refuse("the header ends without a 'format'");
    }
    header_.body = lines_.rest();
    return std::move(header_);
  }

  void line(const Words& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
      return;
    }
    if (words[0] == "format" && words.size() == 3 && !header_.encoding) {
      header_.encoding = encoding(words[1]);
    } else if (words[0] == "element" && words.size() == 3) {
      element(words);
    } else if (words[0] == "property" && !header_.elements.empty()) {
      property(words);
    } else {
      refuse("no line of a PLY header");
    }
  }

  Encoding encoding(std::string_view name) const {
    if (name == "ascii") {
      return Encoding::ascii;
    }
    if (name == "binary_little_endian") {
      return Encoding::little_endian;
    }
    if (name == "binary_big_endian") {
      return Encoding::big_endian;
    }
    refuse("no format of PLY");
  }

  void element(const Words& words) {
    const auto count = parse_integer(words[2]);
    if (!count || *count < 0) {
      refuse("an element without a count");
    }
    if (header_.element(words[1]) != nullptr) {
      refuse("a second element ", quoted(words[1]));
    }
    header_.elements.push_back({words[1], *count, {}});
  }

  void property(const Words& words) {
    const bool is_list = words.size() == 5 && words[1] == "list";
    if (words.size() != 3 && !is_list) {
      refuse("no property of PLY");
    }
    std::vector<PlyProperty>& known = header_.elements.back().properties;
    const std::string_view name = words.back();
    if (std::any_of(known.begin(), known.end(),
                    [&](const PlyProperty& other) { return other.name == name; })) {
      refuse("a second property ", quoted(name));
    }
    known.push_back({name, type(words[words.size() - 2]),
                     is_list ? std::optional(type(words[2])) : std::nullopt});
    if (is_list && known.back().length->kind == PlyType::is_floating) {
      refuse("a list whose length is no integer");
    }
  }

  PlyType type(std::string_view name) const {
    for (const PlyType& type : kTypes) {
      if (type.name == name || type.other_name == name) {
        return type;
      }
    }
    refuse("no type of PLY");
  }

  Lines lines_;
  const std::string& file_;
  PlyHeader header_;
};

}  // namespace

const PlyElement* PlyHeader::element(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& known) { return known.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(std::string_view text, const std::string& file) {
  return HeaderReader(text, file).read();
}

}  // namespace flashbvh::tool
