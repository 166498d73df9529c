#include "mesh/ply_header.hpp"

#include <array>

#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool::ply {
namespace {

constexpr std::array<Type, 8> kTypes = {{{"char", "int8", 1, Type::is_signed},
                                         {"uchar", "uint8", 1, Type::is_unsigned},
                                         {"short", "int16", 2, Type::is_signed},
                                         {"ushort", "uint16", 2, Type::is_unsigned},
                                         {"int", "int32", 4, Type::is_signed},
                                         {"uint", "uint32", 4, Type::is_unsigned},
                                         {"float", "float32", 4, Type::is_floating},
                                         {"double", "float64", 8, Type::is_floating}}};

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  Header read() {
    if (!lines_.next() || words_of(lines_.line()) != Words{"ply"}) {
      throw UserError(file_, "is no PLY file: it does not begin with 'ply'");
    }
    while (lines_.next()) {
      const Words words = words_of(lines_.line());
      if (!words.empty() && words[0] == "end_header") {
        return header_;
      }
      line(words);
    }
    throw UserError(file_, lines_.number(), "the file ends in its header; export the mesh again");
  }

  std::string_view body() const { return lines_.rest(); }

 private:
  using Words = std::vector<std::string_view>;

  [[noreturn]] void refuse(const char* what) const {
    throw UserError(file_, lines_.number(), std::string(what) + "; export the mesh again");
  }

  void line(const Words& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
      return;
    }
    if (words[0] == "format" && words.size() == 3) {
      header_.encoding = encoding(words[1]);
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = parse_integer(words[2]);
      if (!count || *count < 0) {
        refuse("an element without a count");
      }
      header_.elements.push_back({words[1], *count, {}});
    } else if (words[0] == "property" && !header_.elements.empty()) {
      header_.elements.back().properties.push_back(property(words));
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

  Property property(const Words& words) const {
    if (words.size() == 3) {
      return {words[2], type(words[1]), std::nullopt};
    }
    if (words.size() == 5 && words[1] == "list") {
      return {words[4], type(words[3]), type(words[2])};
    }
    refuse("no property of PLY");
  }

  Type type(std::string_view name) const {
    for (const Type& type : kTypes) {
      if (type.name == name || type.other_name == name) {
        return type;
      }
    }
    refuse("no type of PLY");
  }

  Lines lines_;
  const std::string& file_;
  Header header_;
};

}  // namespace

Header read_header(std::string_view text, const std::string& file, std::string_view& body) {
  HeaderReader reader(text, file);
  Header header = reader.read();
  body = reader.body();
  return header;
}

}  // namespace flashbvh::tool::ply
