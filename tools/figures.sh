#!/bin/sh
# figures.sh [PRESET...]             measures the figures of lib/docs/figures.md anew and writes the page
# figures.sh --check [PRESET...]     measures, and fails if anything differs from the page
# figures.sh --compare [PRESET...]   compares what the tests left in the build folders, no more
# figures.sh --trees [PRESET]        whole queries on trees of other leaf sizes and arities: the table of
#                                    lib/docs/decisions/0003-trees.md; default: Cortex-M4F
# figures.sh --prepare               makes build/figures, which builds are given to measure a robot:
#                                    cmake --preset cortex-m4f -DFLASHBVH_KR5_FIGURES="$PWD/build/figures"
#
# PRESET: of CMakePresets.json; all boards unless told. What is measured goes to
# tests/figures/figures.txt, lines `CORE NAME VALUE`; the page is made of that file. Installs what is
# missing.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
. tools/kr5.sh

mode=write
case ${1:-} in
  --check | --compare | --prepare | --trees) mode=${1#--}; shift ;;
  -*) sed -n '2,13s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
folder=$PWD/build/figures
data=tests/figures/figures.txt
# FLASHBVH_NATIVE: the preset whose host program bakes.
native=${FLASHBVH_NATIVE:-native}
flashbvh=$PWD/build/$native/bin/flashbvh
# What measures: the figures, the memory (tests/proof/stack) and the bounds (tests/proof/bound).
tests="figures: measured|memory, and both stacks|bound: no run takes more"
# Each pair of links that no joint connects, of those that fit 256 KB together.
links="bicep forearm palm wrist"
pairs="bicep-palm forearm-palm bicep-forearm bicep-wrist"

# quietly COMMAND...: its output goes to a log, which is shown if it fails.
quietly() {
  "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; echo "figures: this failed: $*" >&2; exit 1; }
}

# bake FOLDER OPTION...: the links' trees; prints their bytes and their triangles.
bake() {
  to=$1
  shift
  "$flashbvh" bake $(for link in $links; do echo "$kr5/$link.STL"; done) -o "$to" "$@" \
    2>"$folder/log" >"$folder/table" || { cat "$folder/log" >&2; exit 1; }
  awk 'FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i }
    $1 == "cell" { exit }
    FNR > 1 { triangles += $column["triangles"]; bytes += $column["flash"] }
    END { print bytes, triangles }' "$folder/table"
}

# visits: of each pair what bounds a query's visits, and the most that any pose takes.
visits() {
  for pair in $pairs; do
    "$flashbvh" collide "$folder/${pair%-*}.fbvh" "$folder/${pair#*-}.fbvh" --bound --json |
      sed 's/[{}"]//g; s/[:,]/ /g' | awk -v pair="$pair" '{
        for (i = 1; i < NF; i += 2) is[$i] = $(i + 1)
        print "all visits." pair ".ranked", is["most_visits"]
        print "all visits." pair ".work", is["most_work"]
        print "all visits." pair ".depths", is["depths"]
        print "all visits." pair ".siblings", is["later_siblings"]
        print "all visits." pair ".leaf_size", is["leaf_size"]
      }'
  done
  # A tree's leaves, and the poses.
  awk -F '[ ={},;"]+' '/uint32_t kLeafCount/ { name = FILENAME; gsub(/.*\/|\.fbvh.*/, "", name)
      for (i = 1; i < NF; ++i) if ($i == "kLeafCount") leaves[name] = $(i + 1)
    }
    /&.*::mesh,/ { pair = $2 "-" $3 }
    /^ *\{\{.*\}, \{/ && $(NF - 4) + 0 > most[pair] + 0 { most[pair] = $(NF - 4) }
    END {
      for (pair in most) {
        split(pair, link, "-")
        printf "all visits.%s.any %.0f\nall visits.%s.observed %d\n", pair,
          2 * leaves[link[1]] * leaves[link[2]] - 1, pair, most[pair]
      }
    }' "$folder"/*.fbvh.hpp "$folder/poses.cpp" | sort
}

# prepare: the links as arrays, the poses, and what they take of flash.
prepare() {
  mkdir -p "$folder"
  quietly cmake --preset $native
  quietly cmake --build --preset $native --target flashbvh_tool write_poses
  fetch_kr5 build/kr5
  rm -f "$folder/host.txt"
  default=$(bake "$folder")
  bake "$folder/leaf1" --leaf-size 1 >/dev/null
  quietly build/$native/bin/write_poses "$folder" "$folder/leaf1" $pairs
  quietly "$flashbvh" robot "$urdf" --name kr5_arm -o "$folder/robot"
  [ $mode != prepare ] || return 0 # that is all that boards are given
  for size in 1 2 3 4 5 6 7 8; do
    flash=$(bake "$folder/leaf$size" --leaf-size $size)
    quietly build/$native/bin/write_poses "$folder/leaf$size" "$folder/leaf1" $pairs
    leaf_size $size $flash >>"$folder/host.txt"
  done
  echo "$default" | awk '{ printf "all flash.default %.1f\n", $1 / $2
    print "all flash.triangles", $2; print "all flash.bytes", $1 }' >>"$folder/host.txt"
  visits >>"$folder/host.txt"
}

# leaf_size SIZE BYTES TRIANGLES: what trees of that leaf size take, and the work that the rotated poses
# need with them.
leaf_size() {
  printf 'all leaf.%d.flash %s\n' "$1" "$(echo "$2 $3" | awk '{ printf "%.1f", $1 / $2 }')"
  # 16 poses of each class and each pair, translated, then rotated.
  awk -F '[ {},]+' '/&.*::mesh,/ { row = 0 }
    /^ *\{\{.*\}, \{/ {
      class = int(row / 16)
      if (class >= 6) print class == 6 ? "close" : "intersecting", $(NF - 1)
      row = (row + 1) % 128
    }' "$folder/leaf$1/poses.cpp" | sort -k 1,1 -k 2,2n | awk -v size="$1" '
    { work[$1, ++n[$1]] = $2; sum[$1] += $2 }
    END {
      for (class in n) {
        name = "all leaf." size ".work." class
        printf "%s.mean %.0f\n%s.max %d\n", name, sum[class] / n[class], name, work[class, n[class]]
      }
    }' | sort
}

# boards: the presets that have one, and are measured (tests/CMakeLists.txt).
boards() {
  awk -F '"' '$2 == "configurePresets" { here = 1 } $2 == "buildPresets" { exit }
    here && $2 == "name" { name = $4 }
    here && /"FLASHBVH_BOARD"/ && name !~ /^(lx106|rv32im)$/ { print name }' CMakePresets.json
}

# measure PRESET: its tests leave figures.txt, memory.txt and bound.txt in its build folder.
measure() {
  quietly cmake --preset "$1" -DFLASHBVH_HOST_TOOL="$flashbvh" -DFLASHBVH_KR5_FIGURES="$folder"
  quietly cmake --build --preset "$1" --target figures
  quietly ctest --preset "$1" -R "$tests"
}

# gather PRESET: its figures in one file, whose name is printed.
gather() {
  [ -r "build/$1/figures.txt" ] ||
    { echo "figures: nothing measured in build/$1: run its tests, or $0 without --compare" >&2; exit 1; }
  gathered=build/$1/measured.txt
  cp "build/$1/figures.txt" "$gathered"
  core=$(awk '$1 != "all" { print $1; exit }' "$gathered")
  for other in memory bound; do
    if [ -r "build/$1/$other.txt" ]; then
      awk -v core="$core" '$NF ~ /^[0-9.]+$/ {
        name = $1
        for (i = 2; i < NF; ++i) name = name "." $i
        print core, name, $NF
      }' "build/$1/$other.txt" >>"$gathered"
    fi
  done
  if [ -r "build/$1/bound.txt" ]; then
    awk -v core="$core" '$1 == "measured" {
        sub(/,/, "", $5)
        print core, "runs." $2 ".observed", $3
        print core, "runs." $2 ".proven", $5
      }' "build/$1/bound_measured.txt" >>"$gathered"
  fi
  if [ "$1" = native ] && [ -r "$folder/host.txt" ]; then
    cat "$folder/host.txt" >>"$gathered"
  fi
  echo "$gathered"
}

# configured PRESET NAME: the value of FLASHBVH_NAME in the build folder.
configured() {
  sed -n "s/^FLASHBVH_$2:INTERNAL=//p" "build/$1/CMakeCache.txt" | tr ';' ' '
}

# trees PRESET: a row for each leaf size and arity; the build is left as it was.
trees() {
  mkdir -p "$folder/trees"
  ln -sfn ../robot "$folder/trees/robot"
  echo "| leaf size | arity | bytes a triangle | close, mean | most | intersecting, mean | most |" \
    "rotated: close, mean | most | intersecting, mean | most |"
  echo "|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
  for size in 1 2 3 4; do
    for arity in 2 3 4 6 8; do
      flash=$(bake "$folder/trees" --leaf-size $size --arity $arity | awk '{ printf "%.1f", $1 / $2 }')
      quietly build/$native/bin/write_poses "$folder/trees" "$folder/leaf1" $pairs
      quietly cmake --preset "$1" -DFLASHBVH_HOST_TOOL="$flashbvh" \
        -DFLASHBVH_KR5_FIGURES="$folder/trees"
      quietly cmake --build --preset "$1" --target figures_kr5
      RUN=$(configured "$1" RUN) FLASHBVH_ICOUNT=$(configured "$1" ICOUNT_SHIFT) \
        quietly tests/figures/run.sh "$folder/trees/figures.txt" "build/$1/bin/figures_kr5.elf"
      awk -v row="| $size | $arity | $flash |" '{ value[$2] = $3 }
        END {
          for (i = split("translated rotated", motion); i > 0; --i) {
            cells = ""
            for (j = split("intersecting close", class); j > 0; --j) {
              name = "kr5.query." motion[i] "." class[j]
              cells = cells " " value[name ".mean"] " | " value[name ".max"] " |"
            }
            row_of[i] = cells
          }
          print row row_of[1] row_of[2]
        }' "$folder/trees/figures.txt"
    done
  done
  quietly cmake --preset "$1" -DFLASHBVH_KR5_FIGURES="$folder"
}

if [ $mode = trees ]; then
  ensure_packages $host_packages $board_packages
  prepare
  trees "${1:-cortex-m4f}"
  exit 0
fi
if [ $mode = prepare ]; then
  ensure_packages $host_packages
  prepare
  echo "$folder"
  exit 0
fi
[ $# -gt 0 ] || set -- native $(boards)
if [ $mode != compare ]; then
  ensure_packages $host_packages $board_packages $riscv_packages
  prepare
  for preset; do
    echo "Measuring $preset"
    measure "$preset"
  done
fi
files=
for preset; do
  files="$files $(gather "$preset")"
done

if [ $mode = write ]; then
  touch $data
  awk -f tests/figures/merge.awk $data $files >"$folder/figures.txt"
  mv "$folder/figures.txt" $data
  tests/figures/page.sh
  costs=lib/include/flashbvh/detail/run_costs.hpp
  awk -v write=1 -f tests/proof/bound/shipped.awk $data $costs >"$folder/costs"
  cmp -s "$folder/costs" $costs || cp "$folder/costs" $costs
fi
# After writing, too: two boards may have one core.
status=0
for file in $files; do
  echo "$file"
  tests/figures/compare.sh "$file" || status=1
done
tests/figures/page.sh --check || status=1
exit $status
