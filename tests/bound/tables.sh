#!/bin/sh
# tables.sh [FOLDER...]
#
# Prints what a run costs at worst, and the most that was measured, in Markdown: a column for each
# core. FOLDER: a build folder in which the tests "bound:" ran; all of build/ unless told, boards
# with the core of another left out.
set -eu
here=$(dirname "$0")
[ $# -gt 0 ] || set -- "$here"/../../build/*/
files=
for folder; do
  [ -r "$folder/bound.txt" ] && [ -r "$folder/bound_measured.txt" ] || continue
  files="$files $folder/bound.txt $folder/bound_measured.txt"
done
[ -n "$files" ] || { echo "tables.sh: no bound.txt: run ctest -R bound: on a board" >&2; exit 2; }
# shellcheck disable=SC2086
exec awk -f "$here/tables.awk" $files
