#!/bin/sh
# Fuzzes what reads bytes, under libFuzzer with the address and undefined-behaviour sanitizers:
#     tests/fuzz/run.sh 600        each program for 600 seconds
#     tests/fuzz/run.sh short      each for a fixed number of inputs, always the same ones
# Needs clang and libclang-rt-14-dev. What it finds lies in build/fuzz/found; put it into corpus/
# beside the mend. Exits with 77 if there is no libFuzzer.
set -eu
cd "$(dirname "$0")/../.."
long=${1:?how many seconds, or short}

printf 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
  clang++ -x c++ - -fsanitize=fuzzer -o /dev/null 2>/dev/null || {
  echo "no libFuzzer: apt-get install clang libclang-rt-14-dev"
  exit 77
}
mkdir -p build
cmake --preset fuzz >build/fuzz.log 2>&1 &&
  cmake --build --preset fuzz --target fuzz_image fuzz_position fuzz_mesh fuzz_robot >>build/fuzz.log 2>&1 || {
  tail -n 40 build/fuzz.log
  exit 1
}

mkdir -p build/fuzz/found
for program in image position mesh robot; do
  seeds=build/fuzz/seeds/$program
  rm -rf "$seeds"
  mkdir -p "$seeds"
  cp tests/fuzz/corpus/$program/* "$seeds"
  case $program in
    image) runs=2500 && cp tests/golden/*.fbvh "$seeds" ;;
    position) runs=15000 ;;
    mesh) runs=12000 ;;
    robot) runs=6000 ;;
  esac
  if [ "$long" = short ]; then
    limit="-runs=$runs -seed=1"
  else
    limit="-max_total_time=$long"
    grown=build/fuzz/grown/$program # kept from run to run
    mkdir -p "$grown"
    seeds="$grown $seeds"
  fi
  echo "== fuzz_$program"
  # shellcheck disable=SC2086
  build/fuzz/bin/fuzz_$program $limit -max_len=3000 -timeout=20 -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix=build/fuzz/found/$program- $seeds \
    >build/fuzz/$program.log 2>&1 || {
    tail -n 60 build/fuzz/$program.log
    exit 1
  }
  grep -E 'cov:|stat::number_of_executed_units|slowest' build/fuzz/$program.log | tail -n 3
done
