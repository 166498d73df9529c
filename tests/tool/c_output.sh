#!/bin/sh
# The C output: strict C99 that holds the image's bytes and what is known of it, under names that
# collide neither with another mesh's nor with C's, and that refuses another version of the library.
. "$SOURCES/common.sh"

# Names that come close to each other, to C's and to the compilers'.
names="part Part PART part_image part_IMAGE part_LEAF int abs size_t INT32_MAX typeof 3rd linux _Bool a_H"
mkdir named
for name in $names; do
  cp meshes/tetrahedron.stl "named/$name.stl"
done
cp meshes/ring.stl "named/base link-2.stl"
for mesh in named/*.stl; do  # one by one: some differ in case alone
  "$FLASHBVH" bake "$mesh" -o baked --format c --unit mm >/dev/null
  "$FLASHBVH" bake "$mesh" -o images --format image --unit mm >/dev/null
done
[ "$(find baked -type f | wc -l)" -eq 32 ] || fail "files: $(ls baked)"

{
  printf '#include <%s.h>\n' stdlib math string stdio
  (cd baked && printf '#include "%s"\n' *.h)
  cat <<'C'
static void write_image(const char* path, const uint32_t* image, size_t size) {
  FILE* file = fopen(path, "wb");
  fwrite(image, 1, size, file);
  fclose(file);
}
int main(void) {
C
  for name in $names base_link_2; do
    word=$(echo "$name" | sed 's/^\([0-9]\)/_\1/; s/^_[A-Z]/m&/')
    echo "  write_image(\"$name.written\", ${word}_image, ${word}_IMAGE_BYTES);"
    echo "  if (sizeof ${word}_image != ${word}_IMAGE_BYTES) return 1;"
  done
  cat <<'C'
  printf("%d %d %d %d %d %d %d %d %.17g\n", base_link_2_NODE_COUNT, base_link_2_LEAF_COUNT,
         base_link_2_DEPTH, base_link_2_STACK_NEED, base_link_2_TRIANGLE_COUNT,
         base_link_2_VERTEX_COUNT, base_link_2_LEAF_SIZE, base_link_2_ARITY, base_link_2_CELL);
  return fabs(base_link_2_CELL * (double)base_link_2_CELLS_PER_UNIT - 1) < 1e-6 ? 0 : 1;
}
C
} >main.c
strictly="-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -I$INCLUDE -Ibaked"
for cc in "$CC" clang; do
  command -v "$cc" >/dev/null || continue
  for standard in c99 gnu17; do
    # shellcheck disable=SC2086
    "$cc" -std=$standard $strictly main.c baked/*.c -o program -lm
  done
done
./program >found || fail "wrong constants"
for name in $names; do
  cmp "$name.written" "images/$name.fbvh"
done
cmp base_link_2.written "images/base link-2.fbvh"
"$FLASHBVH" info "images/base link-2.fbvh" --json | tr ',{' '\n\n' | awk -F: '
  { gsub(/"/, "", $1); value[$1] = $2 }
  END { print value["nodes"], value["leaves"], value["depth"], value["stack_need"],
    value["triangles"], value["vertices"], value["leaf_size"], value["arity"] }' >wanted
cut -d ' ' -f 1-8 found | cmp wanted - || fail "$(cat wanted found)"
cell=$("$FLASHBVH" info "images/base link-2.fbvh" --json | sed 's/.*"cell":\([^,]*\),.*/\1/')
awk -v cell="$cell" '{ exit $9 != cell }' found || fail "cell $cell: $(cat found)"
grep -q 'part_CELL .* in mm ' baked/part.fbvh.h || fail "$(cat baked/part.fbvh.h)"

# C++ may include the headers, too.
for header in baked/*.h; do
  # shellcheck disable=SC2086
  "$CXX" -std=c++17 $strictly -x c++ -fsyntax-only "$header" 2>messages || fail "$(cat messages)"
done

cp -r "$INCLUDE/flashbvh" .
sed -i 's/VERSION_MINOR [0-9]*/VERSION_MINOR 9999/; s/VERSION_MAJOR [0-9]*/VERSION_MAJOR 9999/' \
  flashbvh/version.hpp
if "$CC" -std=c99 -I. -c baked/part.fbvh.c -o object 2>messages; then
  fail "compiled against another version"
fi
grep -q 'part was baked by .*; bake it again' messages || fail "$(cat messages)"
if "$CC" -std=c99 "-I$INCLUDE" -U__BYTE_ORDER__ -D__BYTE_ORDER__=__ORDER_BIG_ENDIAN__ \
  -c baked/part.fbvh.c -o object 2>messages; then
  fail "compiled for a big-endian core"
fi
grep -q 'big-endian' messages || fail "$(cat messages)"

# What C can't open is said where C declares it.
"$FLASHBVH" bake meshes/ring.stl -o pre --format c --layout pre >/dev/null
grep -q 'C has no such meshes' pre/ring.fbvh.h || fail "$(cat pre/ring.fbvh.h)"
grep -q 'For flashbvh_open()' baked/part.fbvh.h || fail "$(cat baked/part.fbvh.h)"
