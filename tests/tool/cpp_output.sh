#!/bin/sh
# The C++ output answers like the image, links no levels that are not used, refuses another version
# of the library, and names its namespace after the mesh.
. "$SOURCES/common.sh"

"$FLASHBVH" bake meshes/ring.stl -o images --format image --cell 0.125 >/dev/null
printf '1 0 0 0 1 0 0 0 1 6 2 1\n' >poses
"$FLASHBVH" collide images/ring.fbvh images/ring.fbvh --poses poses --pairs tool_pairs >/dev/null
"$TOOLS/tool_test_cpp_query" >cpp_pairs
cmp tool_pairs cpp_pairs

"$TOOLS/tool_test_tree_alone"
"$NM" "$TOOLS/tool_test_tree_alone" >symbols
grep -q kNodes symbols || fail "no nodes in the executable"
if grep -E 'kLevels|kRightChildLevels|levelled_tree' symbols; then
  fail "levels linked without use"
fi

mkdir names
for name in 'base link-2' 3rd class; do
  cp meshes/tetrahedron.stl "names/$name.stl"
done
"$FLASHBVH" bake names/*.stl -o named >/dev/null
grep -q '^namespace base_link_2 {' 'named/base link-2.fbvh.hpp' || fail "base link-2"
grep -q '^namespace _3rd {' named/3rd.fbvh.hpp || fail "3rd"
grep -q '^namespace class_ {' named/class.fbvh.hpp || fail "class"
for file in named/*.cpp; do
  "$CXX" -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror -I"$INCLUDE" -c "$file" -o object
done

mkdir -p other_library
cp -r "$INCLUDE/flashbvh" other_library/
sed -i 's/VERSION_MINOR [0-9]*/VERSION_MINOR 9999/; s/VERSION_MAJOR [0-9]*/VERSION_MAJOR 9999/' \
  other_library/flashbvh/version.hpp
if "$CXX" -std=c++17 -Iother_library -c named/class.fbvh.cpp -o object 2>messages; then
  fail "compiled against another version"
fi
grep -q 'bake it again' messages || fail "$(cat messages)"
