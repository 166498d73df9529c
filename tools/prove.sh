#!/bin/sh
# prove.sh               Checks every proof in proofs (lib/docs/proofs.md says what they say): Coq,
#                        gappa and cvc5, on the constants and the lines that lib has today. No axiom, no
#                        proof left out.
# prove.sh --mutations   Then changes definitions and constants one at a time: each must be refused.
#
# Installs what is missing; two programs at a time. What they print is in build/proof.
set -eu
cd "$(dirname "$0")/.."
. tools/packages.sh
case ${1:-} in
  "" | --mutations) ;;
  *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
ensure_packages python3 $proof_packages

out=$PWD/build/proof
rm -rf "$out"
mkdir -p "$out"
proofs/check.sh lib "$out"
[ "${1:-}" != --mutations ] || python3 -B proofs/mutations.py "$out"
