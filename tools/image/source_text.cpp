#include "image/source_text.hpp"

#include <cstring>

#include "flashbvh/float.hpp"
#include "flashbvh/version.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

std::string hex(std::uint64_t value, unsigned digits) {
  std::string text = "0x";
  for (unsigned i = digits; i-- != 0;) {
    text += "0123456789abcdef"[value >> (4 * i) & 15];
  }
  return text + "u";
}

std::string cells_per_unit_literal(double cell) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &cell, sizeof bits);
  return float_literal(cells_per_unit(bits));
}

std::string version_guard(const OutputName& name) {
  std::string condition = concat("#if FLASHBVH_VERSION_MAJOR != ", FLASHBVH_VERSION_MAJOR);
  std::string version = std::to_string(FLASHBVH_VERSION_MAJOR);
  if (FLASHBVH_VERSION_MAJOR == 0) {
    condition += concat(" || FLASHBVH_VERSION_MINOR != ", FLASHBVH_VERSION_MINOR);
    version += concat(".", FLASHBVH_VERSION_MINOR);
  }
  return condition + "\n#error \"" + name.word + " was baked by flashbvh " + version +
         "; bake it again with this version\"\n#endif\n";
}

}  // namespace flashbvh::tool
