#!/bin/sh
# bake_once.sh ARGUMENT...    bakes like flashbvh, but copies files that were already baked for another board from
# build/baked. Bakes again if a file of the kept depfile, as a URDF's mesh, has changed. tools/test_step.sh copies this
# script to the build folder.
set -eu
build=$(cd "$(dirname "$0")" && pwd)
flashbvh=$build/native-sanitize/bin/flashbvh
made=$build/baked/new.$$
before= folder= depfile= request=$(stat -c %y "$flashbvh")
for argument; do
  shift
  key=$argument
  case $before in
    -o) folder=$argument key= argument=$made ;;
    --depfile) depfile=$argument key= argument=$made/depfile ;;
    *) [ ! -f "$argument" ] || key="${argument##*/} $(cksum <"$argument")" ;;
  esac
  before=$argument
  request="$request
$key"
  set -- "$@" "$argument"
done
kept=$build/baked/$(echo "$request" | sha1sum | cut -c 1-40)
if [ -e "$kept/read" ] && ! sha1sum --check --status "$kept/read" 2>/dev/null; then
  rm -r "$kept"
fi
if [ ! -d "$kept" ]; then
  mkdir -p "$made"
  "$flashbvh" "$@"
  # The depfile's first line is its target.
  [ -z "$depfile" ] || sed '1d; s/^  //; s/ \\$//; s/\\ / /g' "$made/depfile" | xargs -d '\n' sha1sum >"$made/read"
  mv -T "$made" "$kept" 2>/dev/null || rm -r "$made" # another board was faster
fi
mkdir -p "$folder"
cp "$kept"/* "$folder"
if [ -n "$depfile" ]; then
  sed "s#$build/baked/new\.[0-9]*#$folder#g" "$kept/depfile" >"$depfile"
  rm "$folder/depfile" "$folder/read"
fi
