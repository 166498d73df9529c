# cmake -DFOLDER=... -DOUT=... -P embed.cmake: writes FOLDER's *.fbvh and answers.txt as a C++ file.
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
file(READ ${FOLDER}/answers.txt hex HEX)
string(REGEX REPLACE "(..)" "0x\\1," answers "${hex}")
file(WRITE ${OUT} "// Written by embed.cmake.
#include \"golden/golden.hpp\"

namespace flashbvh::test {
namespace {
${arrays}
const char answers[] = {${answers}0};
}  // namespace

const KeptImage kKeptImages[] = {
${table}};
const std::size_t kKeptImageCount = sizeof kKeptImages / sizeof kKeptImages[0];
const char* const kKeptAnswers = answers;

}  // namespace flashbvh::test
")
