#!/bin/sh
# FetchContent from a local folder, with images beside the code.
. "$SOURCES/common.sh"
configure built -DWAY=fetch_content "-DFLASHBVH_ROOT=$ROOT" "-DFLASHBVH_HOST_TOOL=$FLASHBVH" \
  "-DOPTIONS=FORMAT;both;UNIT;mm" $bare
bakes built "the first time"
built/consumer || fail "wrong answers"
"$FLASHBVH" check built/flashbvh/parts/peg.fbvh --mesh firmware/peg.obj >log 2>&1 || fail "no image"
rests built "nothing changed"
