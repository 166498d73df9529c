#!/bin/sh
# Sourced by every script: a firmware project in a folder of its own.
set -eu
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"
cp -r "$SOURCES/consumer" firmware
cp "$ROOT"/firmware_examples/quick_start/*.obj firmware
generator=Ninja
baked=parts
# What is compiled here hardly runs.
printf '#!/bin/sh\nexec %s "$@" -O0\n' "${CMAKE_CXX_COMPILER_LAUNCHER:-}" >unoptimised
chmod +x unoptimised
export CMAKE_C_COMPILER_LAUNCHER="$PWD/unoptimised" CMAKE_CXX_COMPILER_LAUNCHER="$PWD/unoptimised"

fail() {
  echo "FAILED: $*" >&2
  [ ! -r log ] || tail -n 40 log >&2
  exit 1
}

# configure BUILD OPTION...: of the firmware.
configure() {
  folder=$1
  shift
  "$CMAKE" -G "$generator" -S firmware -B "$folder" "$@" >log 2>&1 || fail "configure: $*"
}

build() {
  "$CMAKE" --build "$1" >log 2>&1 || fail "build $1"
}

# bakes BUILD, or rests BUILD: the build calls the tool, or has no reason to.
bakes() {
  build "$1"
  grep -q "Baking $baked" log || fail "not baked: $2"
}
rests() {
  build "$1"
  grep -q "Baking $baked" log && fail "baked without a reason: $2"
  return 0
}

# No package but the compiler's: what these options forbid is looked for by nobody.
bare="-DCMAKE_DISABLE_FIND_PACKAGE_assimp=TRUE -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=TRUE
  -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=TRUE -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=TRUE
  -DCMAKE_DISABLE_FIND_PACKAGE_urdfdom=TRUE -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=TRUE"

# The compiler of a cross build in the environment, and what its objects say in `file`-like terms.
enter_cross_environment() {
  printf '%s\n' 'set(CMAKE_SYSTEM_NAME Generic)' 'set(CMAKE_SYSTEM_PROCESSOR arm)' \
    'set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)' >toolchain.cmake
  if command -v arm-none-eabi-g++ >/dev/null; then
    export CC=arm-none-eabi-gcc CXX=arm-none-eabi-g++ LDFLAGS=--specs=nosys.specs
    export CXXFLAGS="-mcpu=cortex-m4 -mthumb -DFOR_THE_TARGET"
  else
    export CC=cc CXX=c++ CXXFLAGS=-DFOR_THE_TARGET
  fi
  export CFLAGS="$CXXFLAGS" CMAKE_TOOLCHAIN_FILE="$PWD/toolchain.cmake"
}

# for_the_target EXECUTABLE
for_the_target() {
  [ -s "$1" ] || fail "no $1"
  [ "$CXX" = c++ ] || arm-none-eabi-readelf -h "$1" | grep -q 'Machine: *ARM' || fail "$1 is no ARM program"
}
