#!/bin/sh
# All files get written and told of, or none: when nothing may be written, when standard output takes
# nothing, and when a signal comes.
. "$SOURCES/common.sh"
bake="bake meshes/ring.stl meshes/tetrahedron.stl --unit mm"

# A dry run prints what a real one prints, fails where it fails, and writes nothing.
for options in "" "--format c" "--format image --leaf-size 5" "--cell 0.0001" "--max-bytes 1000"; do
  code=0
  # shellcheck disable=SC2086
  "$FLASHBVH" $bake $options -o wet >wet_stdout 2>wet_stderr || code=$?
  for folder in "" "-o out"; do
    # shellcheck disable=SC2086
    exits $code $bake $options $folder --dry-run
    cmp wet_stdout stdout
    cmp wet_stderr stderr
    [ ! -e out ] || fail "a dry run made a folder"
  done
done

# What firmware links comes first; then a row for all, and the unit of each length.
exits 0 bake meshes/ring.stl meshes/tetrahedron.stl --cell 0.25 --unit mm -o table
awk '
  NR == 1 && !/^mesh +flash  bytes\/triangle +image  triangles / { exit 1 }
  $1 == "ring" || $1 == "tetrahedron" {
    for (i = 2; i <= 7; ++i) sum[i] += $i
    if ($9 > largest) largest = $9
  }
  $1 == "total" {
    for (i = 2; i <= 7; ++i) if (i != 3 && $i != sum[i]) exit 1
    ++totals
    if ($3 != sprintf("%.1f", $2 / $5) || $9 != largest) exit 1
  }
  $1 != "mesh" && $1 != "cell" && $1 != "total" && !/  [0-9.]+ mm  +[0-9.]+ x [0-9.]+ x [0-9.]+ mm$/ { exit 1 }
  $1 == "total" && !/  [0-9.]+ mm$/ { exit 1 }
  $1 == "cell" && !/^cell 0.25 mm;/ { exit 1 }
  END { if (NR != 5 || totals != 1) exit 1 }' stdout || fail "$(cat stdout)"
bytes=$(sed -n 's/.*kFlashBytes = \([0-9]*\);.*/\1/p' table/ring.fbvh.hpp)
grep -q "^ring  *$bytes " stdout || fail "not $bytes: $(cat stdout)"
# The same as JSON, with the warnings.
"$FLASHBVH" bake meshes/ring.stl meshes/tetrahedron.stl --cell 0.25 --unit mm --dry-run --json >json
python3 - <<'PYTHON' || fail "$(cat json)"
import json
found = json.load(open("json"))
rows = [line.split() for line in open("stdout") if line.split()[0] in ("ring", "tetrahedron")]
assert (found["unit"], found["cell"], found["warnings"]) == ("mm", 0.25, [])
for row, mesh in zip(rows, found["meshes"], strict=True):
    names = "name flash_bytes image_bytes triangles vertices nodes depth".split()
    assert [str(mesh[name]) for name in names] == row[:2] + row[3:8], mesh
    assert abs(mesh["deviation"] - float(row[8])) < 1e-4
    assert [f"{side:.3g}" for side in mesh["size"]] == [row[10], row[12], row[14]]
PYTHON
exits 0 bake meshes/ring.stl --cell 0.25 --format image -o table
grep -q "^ring  *$(($(wc -c <table/ring.fbvh))) " stdout || fail "$(cat stdout)"
grep -q total stdout && fail "a row for all of one mesh"
refused "meshes/ring.stl: is too large for a cell of 1e-04 mm: " \
  bake meshes/ring.stl -o out --unit mm --cell 0.0001
refused "--max-deviation allows 0.1 mm; a cell of 0.11547005383792516 mm or less" \
  bake meshes/ring.stl -o out --unit mm --cell 1 --max-deviation 0.1

# Standard output that takes nothing: nobody would hear of the files.
exits 0 bake meshes/ring.stl -o images
echo "1 0 0 0 1 0 0 0 1 0 0 0" >poses
if [ -c /dev/full ]; then
  for command in "bake meshes/ring.stl -o out" "bake meshes/ring.stl --dry-run" "info images/ring.fbvh" \
    "collide images/ring.fbvh images/ring.fbvh --poses poses --pairs out" --help --version "bake --help"; do
    code=0
    # shellcheck disable=SC2086
    "$FLASHBVH" $command >/dev/full 2>stderr || code=$?
    [ $code -eq 2 ] || fail "exit $code, not 2: $command"
    grep -q "^flashbvh: standard output can't be written$" stderr || fail "$(cat stderr)"
    [ ! -e out ] || fail "written by: $command"
  done
fi

# bake_until_full: starts `bake` with a full pipe for standard output, the other end being ours, and
# waits until all bytes are on the disk, under temporary names.
bake_until_full() {
  rm -rf out pipe
  mkfifo pipe
  exec 3<>pipe
  dd if=/dev/zero of=pipe bs=64 oflag=nonblock 2>/dev/null || :
  "$FLASHBVH" bake meshes/ring.stl -o out >pipe 2>/dev/null 3>&- &
  process=$!
  tries=0
  until [ "$(find out -name '*.tmp*' -size +1 2>/dev/null | wc -l)" -eq 3 ]; do
    tries=$((tries + 1))
    [ $tries -lt 500 ] || fail "no temporary files"
    sleep 0.02
  done
}
# ends CODE: once the pipe is read.
ends() {
  cat <pipe >/dev/null 3>&- &
  exec 3>&-
  code=0
  wait $process || code=$?
  wait
  [ $code -eq "$1" ] || fail "exit $code, not $1"
}
for signal in 1 15; do
  bake_until_full
  kill -$signal $process
  ends $((128 + signal))
  [ ! -e out ] || fail "left behind by signal $signal: $(ls out)"
done
# nohup.
trap '' HUP
bake_until_full
kill -HUP $process
ends 0
[ "$(find out -type f | wc -l)" -eq 3 ] || fail "not all written: $(ls out)"
trap - HUP
# Nobody reads any more.
bake_until_full
exec 3>&-
code=0
wait $process || code=$?
[ $code -eq 141 ] || fail "exit $code of a broken pipe"
[ ! -e out ] || fail "left behind by a broken pipe: $(ls out)"
