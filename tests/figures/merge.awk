# The data, then what was measured: prints the data with each group that was measured replaced. The
# first measurement counts. Cores stay in the order in which they came, figures likewise.
function group_of(core, name) {
  sub(/\..*/, "", name)
  return core SUBSEP name
}

FILENAME == ARGV[1] {
  old[$1, $2] = $3
}

FILENAME != ARGV[1] && !(($1, $2) in new) {
  new[$1, $2] = $3
  is_measured[group_of($1, $2)] = 1
}

!($1 in is_core) {
  is_core[$1] = 1
  core[cores++] = $1
}

!($2 in is_name) {
  is_name[$2] = 1
  name[names++] = $2
}

END {
  for (c = 0; c < cores; ++c) {
    for (n = 0; n < names; ++n) {
      if ((core[c], name[n]) in new) {
        print core[c], name[n], new[core[c], name[n]]
      } else if (((core[c], name[n]) in old) && !(group_of(core[c], name[n]) in is_measured)) {
        print core[c], name[n], old[core[c], name[n]]
      }
    }
  }
}
