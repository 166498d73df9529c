# Sourced: fetch_kr5 FOLDER sets `kr5` to the folder of a KUKA KR5's meshes and `urdf` to its joints' file.
# Both come from Debian's package dart-doc (BSD-2-Clause), which is kept in FOLDER.

fetch_kr5() {
  kr5=$1/dart/usr/share/doc/dart/data/urdf/KR5/meshes
  urdf="${kr5%/*}/KR5 sixx R650.urdf"
  if [ ! -r "$urdf" ] || [ ! -r "$kr5/palm.STL" ]; then
    mkdir -p "$1"
    (cd "$1" && apt-get download dart-doc >log 2>&1) ||
      { cat "$1/log" >&2; echo "$0: 'apt-get download dart-doc' failed; is there a network, and has
'apt-get update' been run?" >&2; return 1; }
    dpkg-deb -x "$1"/dart-doc_*.deb "$1/dart"
  fi
}
