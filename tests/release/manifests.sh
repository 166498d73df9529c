#!/bin/sh
# The packages' manifests; none contains a path of the machine that made it.
. "$(dirname "$0")/common.sh"
/usr/bin/python3 -c "import jsonschema, kconfiglib, pykwalify.core, yaml" && command -v xmllint || exit 77
/usr/bin/python3 "$ROOT/tests/release/manifests.py" "$PACKAGES" "$ROOT/lib/docs/packages.md" || fail "manifests.py"
xmllint --noout "$PACKAGES"/cmsis/flashbvh/*.pdsc
! grep -rlF -e "$ROOT" "$PACKAGES" || fail "a path of this machine"
