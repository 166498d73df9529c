# See compare.sh. The first file is the data, the others were measured now.
#
# The first word of a name is its group (kr5, tori, stack, ...). Groups come from programs of their
# own, which not every build has; of a group that was measured nothing may be missing.
function group_of(core, name) {
  sub(/\..*/, "", name)
  return core SUBSEP name
}

function complain(what) {
  print $1, $2 ": " what
  ++failures
}

NF != 3 {
  print "compare.awk: not a figure: " FILENAME ": " $0
  ++failures
  next
}

FNR == NR {
  documented[$1, $2] = $3
  next
}

{
  ++compared
  measured[$1, $2] = 1
  is_measured[group_of($1, $2)] = 1
}

!(($1, $2) in documented) {
  complain($3 ", and not documented: run tools/figures.sh")
  next
}

{
  was = documented[$1, $2]
}

$1 == "all" && $3 + 0 != was + 0 {
  complain($3 ", on the page " was ": every core has to count the same")
  next
}

$1 != "all" && $3 * 100 > was * (100 + slack) {
  complain($3 ", more than " slack " % above the " was " on the page")
}

$1 != "all" && $3 * 100 < was * (100 - slack) {
  complain($3 ", better than documented, " was ": run tools/figures.sh")
}

END {
  for (figure in documented) {
    split(figure, part, SUBSEP)
    if ((group_of(part[1], part[2]) in is_measured) && !(figure in measured)) {
      print part[1], part[2] ": on the page, and was not measured"
      ++failures
    }
  }
  if (!compared) {
    print "compare.awk: nothing was measured"
    exit 1
  }
  printf "figures: %d compared, %d differ\n", compared, failures
  exit failures != 0
}
