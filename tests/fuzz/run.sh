#!/bin/sh
# Fuzzes the readers, under libFuzzer with the address and undefined-behaviour sanitizers:
#     tests/fuzz/run.sh 600 [OPTION...]   each program for 600 seconds, with libFuzzer's options, as -max_len=300
#     tests/fuzz/run.sh short             each for a fixed number of inputs, always the same ones; only with
#                                         FLASHBVH_THOROUGH, because building takes long
# PROGRAMS="mesh text" selects programs. Needs clang and libclang-rt-14-dev. Findings are stored in build/fuzz/found;
# add each to corpus/ with its fix. Exits with 77 if there is no libFuzzer, or if it is skipped.
set -eu
cd "$(dirname "$0")/../.."
long=${1:?how many seconds, or short}
shift
programs=${PROGRAMS:-image position mesh robot c text}
if [ "$long" = short ] && [ -z "${FLASHBVH_THOROUGH:-}" ]; then
  echo "left out: FLASHBVH_THOROUGH=1 tests/fuzz/run.sh short"
  exit 77
fi

printf 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
  clang++ -x c++ - -fsanitize=fuzzer -o /dev/null 2>/dev/null || {
  echo "no libFuzzer: apt-get install clang libclang-rt-14-dev"
  exit 77
}
mkdir -p build/fuzz/found
cmake --preset fuzz >build/fuzz.log 2>&1 &&
  cmake --build --preset fuzz --target $(for program in $programs; do echo fuzz_$program; done) >>build/fuzz.log 2>&1 || {
  tail -n 40 build/fuzz.log
  exit 1
}

# Stacks of allocations would cost a fifth of the inputs; replaying a finding shows them.
export ASAN_OPTIONS="malloc_context_size=2:quarantine_size_mb=32${ASAN_OPTIONS:+:$ASAN_OPTIONS}"
for program in $programs; do
  seeds=build/fuzz/seeds/$program
  rm -rf "$seeds"
  mkdir -p "$seeds"
  cp tests/fuzz/corpus/$program/* "$seeds"
  case $program in # inputs of a short run: expensive ones are fewer
    image) runs=2500 && cp tests/golden/*.fbvh "$seeds" ;;
    position) runs=15000 ;;
    mesh) runs=12000 ;;
    c) runs=10000 ;;
    *) runs=6000 ;;
  esac
  grown=build/fuzz/grown/$program # kept from run to run
  mkdir -p "$grown"
  case $long in
    short) limit="-runs=$runs -seed=1" grown= ;;
    *) limit=-max_total_time=$long ;;
  esac
  echo "== fuzz_$program"
  log=build/fuzz/$program.log
  # shellcheck disable=SC2086
  build/fuzz/bin/fuzz_$program -max_len=3000 -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix=build/fuzz/found/$program- $limit "$@" $grown "$seeds" >"$log" 2>&1 || {
    tail -n 60 "$log"
    exit 1
  }
  sed -n 's/.*number_of_executed_units: *\([0-9]*\).*/\1 inputs/p' "$log"
done
