#!/bin/sh
# The npm package of the library as users install it; its types by TypeScript, if npm can download it.
. "$(dirname "$0")/common.sh"
command -v npm >/dev/null && command -v node >/dev/null || { echo "SKIPPED: no npm"; exit 77; }

printf '{"private": true, "type": "module"}\n' >package.json
quietly npm install --no-audit --no-fund --offline "$(echo "$PACKAGES"/npm/flashbvh-library-*.tgz)"
cp "$ROOT"/firmware_examples/quick_start/*.obj .
quietly "$FLASHBVH" bake plate.obj peg.obj --unit mm --format image -o .
quietly "$FLASHBVH" robot "$ROOT/firmware_examples/robot_guard/cell_arm/cell_arm.urdf" --stop 0.005 --format image -o .
mv ./*.robot arm.robot
sed -n '/^## JavaScript$/,/^## /{/^```js$/,/^```$/{/^```/!p;};}' "$ROOT/lib/docs/packages.md" >page.js
node page.js >answer || fail "the page's example"
grep -q "^Uint8Array(2) \[ 0, 1 \] Uint8Array(2)" answer || fail "the page's example printed: $(cat answer)"

quietly npm install --no-audit --no-fund typescript@5 || { echo "types not checked: no TypeScript"; exit 0; }
cp "$ROOT/tests/npm/library/types_test.ts" .
for resolution in nodenext bundler; do
  module=esnext
  [ $resolution = bundler ] || module=$resolution
  quietly npx tsc --noEmit --strict --target es2022 --module $module --moduleResolution $resolution types_test.ts
done
