#!/bin/sh
# Fuzzes the readers, under libFuzzer with the address and undefined-behaviour sanitizers:
#     tests/fuzz/run.sh 600                        each program for 600 seconds
#     tests/fuzz/run.sh --executions 100000000     this number of inputs in all, without a time limit; JOBS=4 runs
#                                                  four processes of each program, one program after the other;
#                                                  files of text and meshes have at most 300 bytes
#     tests/fuzz/run.sh short                      each for a fixed number of inputs, always the same ones; only
#                                                  with FLASHBVH_THOROUGH, because building takes long
# PROGRAMS="mesh text" selects programs. Needs clang and libclang-rt-14-dev. Findings are stored in build/fuzz/found;
# add each to corpus/ with its fix. Exits with 77 if there is no libFuzzer, or if it is skipped.
set -eu
cd "$(dirname "$0")/../.."
long=${1:?how many seconds, --executions N, or short}
programs=${PROGRAMS:-image position mesh robot c text}
[ "$long" != --executions ] || executions=${2:?how many inputs}
jobs=${JOBS:-1}
if [ "$long" = short ] && [ -z "${FLASHBVH_THOROUGH:-}" ]; then
  echo "left out: FLASHBVH_THOROUGH=1 tests/fuzz/run.sh short"
  exit 77
fi

printf 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
  clang++ -x c++ - -fsanitize=fuzzer -o /dev/null 2>/dev/null || {
  echo "no libFuzzer: apt-get install clang libclang-rt-14-dev"
  exit 77
}
mkdir -p build
cmake --preset fuzz >build/fuzz.log 2>&1 &&
  cmake --build --preset fuzz --target $(for program in $programs; do echo fuzz_$program; done) >>build/fuzz.log 2>&1 || {
  tail -n 40 build/fuzz.log
  exit 1
}

mkdir -p build/fuzz/found
# Stacks of allocations would cost a fifth of the inputs; replaying a finding shows them.
export ASAN_OPTIONS="malloc_context_size=2:quarantine_size_mb=32${ASAN_OPTIONS:+:$ASAN_OPTIONS}"
for program in $programs; do
  seeds=build/fuzz/seeds/$program
  rm -rf "$seeds"
  mkdir -p "$seeds"
  cp tests/fuzz/corpus/$program/* "$seeds"
  # `share`: of 1,000 inputs; expensive inputs get fewer. `most`: the largest size in bytes in runs of many inputs.
  most=3000
  case $program in
    image) runs=2500 share=10 && cp tests/golden/*.fbvh "$seeds" ;;
    position) runs=15000 share=30 ;;
    mesh) runs=12000 share=465 most=300 ;;
    robot) runs=6000 share=20 ;;
    c) runs=10000 share=10 ;;
    text) runs=6000 share=465 most=300 ;;
  esac
  log=build/fuzz/$program.log
  options="-max_len=3000 -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix=build/fuzz/found/$program-"
  grown=build/fuzz/grown/$program # kept from run to run
  mkdir -p "$grown"
  case $long in
    short) options="$options -runs=$runs -seed=1" grown= ;;
    --executions) options="$options -runs=$((executions / 1000 * share / jobs + 1)) -reload=100 -max_len=$most" ;;
    *) options="$options -max_total_time=$long" ;;
  esac
  echo "== fuzz_$program"
  rm -f "$log".*
  job=0
  processes=
  while [ $job -lt "$jobs" ]; do
    # shellcheck disable=SC2086
    build/fuzz/bin/fuzz_$program $options $grown $seeds >"$log.$job" 2>&1 &
    processes="$processes $!"
    job=$((job + 1))
  done
  for process in $processes; do
    wait "$process" || {
      grep -l -E 'ERROR|FOUND|deadly' "$log".* | head -n 1 | xargs tail -n 60
      exit 1
    }
  done
  inputs=$(sed -n 's/.*number_of_executed_units: *//p' "$log".* | paste -s -d+)
  echo "$((inputs)) inputs, $(sed -n 's/.* cov: \([0-9]*\).*/\1/p' "$log".* | sort -n | tail -n 1) places reached"
done
