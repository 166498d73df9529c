#!/bin/sh
# check.sh LIB OUT [NAME...]   Checks the proofs, or those with these names, of the code in LIB, in the folder OUT.
#
# A Coq file prints its theorems with `Print Assumptions`. A gappa file proves one claim, stated in its first line. A
# cvc5 file has, after each check, a comment with the expected result and its meaning:
#   (check-sat-assuming (FORMULA)) ; unsat: no box ...
set -eu
here=$(cd "$(dirname "$0")" && pwd)
lib=$(cd "$1" && pwd) out=$2
shift 2
walk="Constants.v Ranked.v Code.v Stackless.v Query.v Image.v Work.v Proved.v"
arithmetic="Margins.v Slabs.v Triangle.v Segment.v Helly.v Flat.v Lines.v Test.v Rejects.v"
both="Exact.v"
python3 -B "$here/prelude.py" "$lib" "$out" "$here"/walk/*.v "$here"/arithmetic/*.v \
  "$here"/arithmetic/*.g "$here"/arithmetic/*.smt2
cd "$out"

# Runs a checker; on failure prints its first words, and the name of the full log.
attempt() {
  name=$1
  shift
  "$@" >"$name.log" 2>&1 || { printf '%s: REFUSED\n' "$name"; head -n 12 "$name.log"; return 1; }
}

# Every printed theorem must be closed, and no other output is allowed.
coq() {
  for file; do
    attempt "$file" coqc -q "$file" || return 1
    theorems=$(sed -n 's/^Print Assumptions \(.*\)\.$/\1/p' "$file")
    [ "$(grep -c "^Closed under the global context" "$file.log" || true)" = \
      "$(echo "$theorems" | grep -c . || true)" ] || { echo "$file: REFUSED: an axiom"; return 1; }
    [ -z "$theorems" ] || printf '%-22s %s\n' "$file" "$(echo $theorems)"
  done
}
gappas() {
  for file; do
    attempt "$file" gappa "$file" || return 1
    printf '%-22s %s\n' "$file" "$(sed -n '1s/^# *//p' "$file")"
  done
}
solvers() {
  for file; do
    sed -n 's/^(check-sat.* ; \(unsat\|sat\):.*/\1/p' "$file" >"$file.expected"
    attempt "$file" cvc5 --incremental "$file" || return 1
    cmp -s "$file.log" "$file.expected" ||
      { echo "$file: REFUSED"; diff "$file.log" "$file.expected" | head; return 1; }
    printf '%-22s %s\n' "$file" "$(sed -n '1s/^; *//p' "$file")"
  done
}
wanted() {  # the requested ones of these files
  for file; do
    [ -e "$file" ] || continue
    case " $names " in "  " | *" $file "*) echo "$file" ;; esac
  done
}
# The definitions of Code.v, Image.v and Exact.v agree with the library on random trees.
differential() {
  attempt differential ${CXX:-g++} -std=c++17 -O1 -I "$lib/include" -I "$lib/src" -I "$here/.." -I "$here/../tests" \
    "$here/walk/differential.cpp" "$lib/src/lattice/tree_check.cpp" -o differential.out || return 1
  ./differential.out >Differential.v || { echo "differential.cpp: too few trees of a kind"; return 1; }
  attempt Differential.v coqc -q -w none Differential.v || return 1
  printf '%-22s %s\n' Differential.v "$(grep -c '^Goal' Differential.v) trees: as the library"
}
names="$*"
began=$(date +%s)
# In parallel: the walk and all that is not Coq's, and arithmetic; then the proofs that use both.
{ coq $(wanted $walk) &&
    gappas $(wanted *.g) && solvers $(wanted *.smt2); } >walk.said 2>&1 &
one=$!
coq $(wanted $arithmetic) >arithmetic.said 2>&1 &
two=$!
status=0
wait $one || status=1
wait $two || status=1
cat walk.said arithmetic.said
[ $status -ne 0 ] || { coq $(wanted $both) && { [ -n "$names" ] || differential; }; } || status=1
! grep -nE '^ *(Admitted|Axiom|Parameter|Conjecture)|admit\.' ./*.v || status=1
[ $status -eq 0 ] || { echo "== A proof was refused" >&2; exit 1; }
echo "== All proofs checked in $(($(date +%s) - began)) s"
