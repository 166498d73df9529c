#!/bin/sh
# Sourced after common.sh: what URDFs of tests are made of.

# link NAME INSIDE
link() { printf '<link name="%s">%s</link>\n' "$1" "$2"; }
# shape GEOMETRY [ORIGIN]
shape() { printf '<collision>%s<geometry>%s</geometry></collision>' "${2-}" "$1"; }
# box SIZE PLACE
box() { shape "<box size=\"$1\"/>" "<origin xyz=\"$2\"/>"; }
# joint NAME TYPE PARENT CHILD INSIDE
joint() {
  printf '<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/>%s</joint>\n' "$@"
}
# limits LOWER UPPER
limits() { printf '<limit lower="%s" upper="%s" effort="1" velocity="1"/>' "$@"; }
