# cmake -DFOLDER=... -DOUT=... -P embed.cmake: writes FOLDER's *.fbvh as a C++ file.
file(GLOB images ${FOLDER}/*.fbvh)
list(SORT images)
set(arrays "")
set(table "")
foreach(image ${images})
  get_filename_component(name ${image} NAME_WE)
  string(REPLACE "-" "_" symbol ${name})
  file(READ ${image} hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(APPEND arrays "alignas(4) const unsigned char ${symbol}[] = {${bytes}};\n")
  string(APPEND table "    {\"${name}\", ${symbol}, sizeof ${symbol}},\n")
endforeach()
file(WRITE ${OUT} "// Written by embed.cmake.
#include \"golden/golden.hpp\"

namespace flashbvh::test {
namespace {
${arrays}
}  // namespace

const KeptImage kKeptImages[] = {
${table}};
const std::size_t kKeptImageCount = sizeof kKeptImages / sizeof kKeptImages[0];

}  // namespace flashbvh::test
")
