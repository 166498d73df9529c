#!/bin/sh
# The C++ output compiles whatever the mesh is called, before and after all headers of C and C++: by
# names that those headers declare or define, taken from what the compilers say, and by keywords. By
# one standard, with FLASHBVH_THOROUGH by others, too.
. "$SOURCES/common.sh"

headers="assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign
  stdarg stdbool stddef stdint stdio stdlib string tgmath time wchar wctype unistd search strings
  sys/stat sys/types sys/socket pthread fcntl sched"
cpp_headers="algorithm atomic cmath cstdlib cstring ctime iostream string thread"

# includes COMPILER: those of the headers that it has.
includes() {
  for header in $headers; do
    printf '#if __has_include(<%s.h>)\n#include <%s.h>\n#endif\n' "$header" "$header"
  done
  for header in $cpp_headers; do
    printf '#if __has_include(<%s>)\n#include <%s>\n#endif\n' "$header" "$header"
  done
}
includes >headers.hpp

# Names that are taken: keywords; macros; tags, and what stands before a bracket or a semicolon in the
# headers of C, which is more than they declare.
names_of() {
  printf '%s\n' abs exit size_t uint32_t INT32_MAX UINT8_C typeof asm linux unix class and xor_eq \
    co_yield char8_t nullptr std flashbvh posix main __arm__ _Bool __x _Upper errno stdin NULL EOF \
    SIGINT E2BIG link pipe socket stat timeval tm div_t y0 sinf strtol I M_PI va_arg jmp_buf \
    int8_t restrict _Alignas noreturn bool true complex index select
  for header in assert complex ctype errno fenv inttypes limits locale math setjmp signal stdarg \
    stddef stdint stdio stdlib string time wchar wctype; do
    echo "#include <$header.h>"
  done >c_headers.c
  $1 -std=gnu11 -D_GNU_SOURCE -E -dM c_headers.c | sed -n 's/^#define \([A-Za-z]\w*\).*/\1/p'
  $1 -std=gnu11 -D_GNU_SOURCE -E -P c_headers.c |
    grep -oE '\b[A-Za-z]\w* *[(;]|\b(enum|struct|union) \w+' | sed 's/.* \(.\)/\1/; s/[ (;]//g'
}

# compiles COMPILER...
compiles() {
  "$@" -I"$INCLUDE" -Ibaked -fsyntax-only both.cpp 2>messages || fail "$* ($(head -n 5 messages))"
}

standards=gnu++20
! thorough || standards="c++17 gnu++17 gnu++20"
for prefix in "" arm-none-eabi-; do
  cc=${prefix}gcc
  command -v "$cc" >/dev/null || continue
  rm -rf named baked
  mkdir named
  names_of "$cc" | sort -u | awk '{
    folder = "named/" ++spellings[tolower($0)]  # one call takes one of those that differ in case alone
    if (!made[folder]++) system("mkdir " folder)
    mesh = folder "/" $0 ".obj"
    printf "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" >mesh
    close(mesh)
  }'
  [ "$(find named -type f | wc -l)" -gt 500 ] || fail "few names"
  for folder in named/*; do
    "$FLASHBVH" bake "$folder"/*.obj -o baked --format cpp --cell 1 >/dev/null 2>messages ||
      fail "$(tail -n 1 messages)"
  done
  (cd baked && printf '#include "%s"\n' *.hpp) >meshes.hpp
  printf '#include "%s.hpp"\n' headers meshes headers >both.cpp
  for standard in $standards; do
    compiles "${prefix}g++" -std=$standard -I.
    [ "$prefix" ] || ! command -v clang++ >/dev/null || compiles clang++ -std=$standard -I.
  done
  printf '#include "%s.hpp"\n' meshes headers >both.cpp
  compiles "${prefix}g++" -std=gnu++17 -I.
done

# Other names stay as they are, and a name that is taken is not accepted.
mkdir free
for name in arm base_link tool left torso leaf_2 Base island structure memory signals timeout; do
  cp meshes/tetrahedron.stl free/$name.stl
done
"$FLASHBVH" bake free/*.stl -o freely --format cpp >/dev/null
for name in arm base_link tool left torso leaf_2 Base island structure memory signals timeout; do
  grep -q "^namespace $name {" freely/$name.fbvh.hpp || fail "$name is called otherwise"
done
refused "--name abs: is a name that C or C++ takes; use another, such as abs_" \
  bake meshes/ring.stl -o out --name abs
exits 0 bake meshes/ring.stl -o images --name abs_
