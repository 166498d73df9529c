#!/bin/sh
# The Python package: its source archive, built and installed by pip without the repository, and Debian's package
# pass the tests.
. "$(dirname "$0")/common.sh"
quietly /usr/bin/python3 -m pip install --no-build-isolation --no-deps --no-index --target "$WORK/pip" \
  "$PACKAGES"/python/flashbvh-*.tar.gz
dpkg-deb -x "$PACKAGES"/debian/python3-flashbvh_*.deb debian
for installed in pip debian/usr/lib/python3/dist-packages; do
  for test in mesh robot; do
    SOURCES="$ROOT" PYTHONPATH="$WORK/$installed" quietly /usr/bin/python3 -B -W error "$ROOT/tests/python/${test}_test.py"
  done
done
