#!/bin/sh
# The machine's flags reach firmware by a target alone, as Zephyr's do: FLASHBVH_LINK brings them to the
# library and the baked meshes, from its sources and from a package.
. "$SOURCES/common.sh"
enter_cross_environment
export CXXFLAGS= CFLAGS=
flags="-mcpu=cortex-m4;-mthumb;-mfloat-abi=hard;-mfpu=fpv4-sp-d16"
[ "$CXX" != c++ ] || flags=-DFOR_THE_TARGET
last=${flags##*;}

# shellcheck disable=SC2086
"$CMAKE" -G Ninja -S "$ROOT" -B library -DFLASHBVH_BUILD_TOOL=OFF $bare >log 2>&1 || fail configure
"$CMAKE" --install library --prefix prefix >log 2>&1 || fail install
for way in add_subdirectory find_package; do
  configure $way -DWAY=$way "-DFLASHBVH_ROOT=$ROOT" "-DFLASHBVH_HOST_TOOL=$FLASHBVH" \
    "-Dflashbvh_DIR=$(dirname "$(find "$PWD/prefix" -name flashbvhConfig.cmake)")" \
    "-DMACHINE=$flags" -DROBOT= -DFLASHBVH_LINK=machine -DCMAKE_EXPORT_COMPILE_COMMANDS=ON $bare
  grep '"command"' $way/compile_commands.json >commands
  [ "$(wc -l <commands)" -gt 10 ] || fail "few sources: $way"
  if grep -v -e "$last" commands; then
    fail "compiled for another machine: $way"
  fi
  build $way
  for_the_target $way/consumer
done

# Without it, linking fails.
if [ "$CXX" != c++ ]; then
  configure wrong -DWAY=add_subdirectory "-DFLASHBVH_ROOT=$ROOT" "-DFLASHBVH_HOST_TOOL=$FLASHBVH" \
    "-DMACHINE=$flags" $bare
  "$CMAKE" --build wrong >log 2>&1 && fail "linked with a library for another machine"
fi
:
