# check.awk TAGS BUDGETS FIGURES...: whether the figures agree and keep their budgets. Prints them.
#
# FIGURES: "code ENTRY Os|O2 BYTES", "stack ENTRY graph|painted BYTES", "object NAME BYTES"; other
# lines are not looked at. A stack's two figures must not differ by more than 16 bytes, and what was
# painted never exceeds what the call graph allows. TAGS: what the board's core is, by commas;
# BUDGETS (budgets.txt) are checked where one of the tags is theirs.
BEGIN {
  most_apart = 16
  n = split(ARGV[1], list, ",")
  for (i = 1; i <= n; ++i) {
    tags[list[i]] = 1
  }
  ARGV[1] = ""
}

FNR == 1 { ++file }
/^#/ || /^$/ { next }
file == 1 {
  key = $2 " " $3 ($2 == "code" ? " " $4 : "")
  if ($1 in tags && (!(key in limit) || $NF + 0 < limit[key])) {
    limit[key] = $NF + 0
  }
  next
}
/^(code|stack) [a-z_]+ [A-Za-z0-9]+ [0-9]+$/ || /^object [A-Za-z]+ [0-9]+$/ {
  print
  ++figures
  if ($1 == "stack") {
    stack[$2, $3] = $4
    is_root[$2] = 1
    keep("stack " $2, $4)
  } else {
    keep($1 == "code" ? $1 " " $2 " " $3 : $1 " " $2, $NF)
  }
}

END {
  for (root in is_root) {
    if (!((root, "graph") in stack) || !((root, "painted") in stack)) {
      wrong(root ": only one of the two figures of its stack")
      continue
    }
    apart = stack[root, "graph"] - stack[root, "painted"]
    if (apart < 0) {
      wrong(root ": painted " stack[root, "painted"] ", above the call graph's " \
        stack[root, "graph"])
    } else if (apart > most_apart) {
      wrong(root ": painted " stack[root, "painted"] ", " apart " below the call graph")
    }
  }
  for (key in limit) {
    if (!(key in kept)) {
      wrong("a budget for what was not measured: " key)
    }
  }
  if (figures == 0) {
    wrong("no figures")
  }
  exit failed
}

function keep(key, bytes) {
  if (key in limit) {
    kept[key] = 1
    print "budget: " key ": " bytes " bytes, at most " limit[key] > "/dev/stderr"
    if (bytes > limit[key]) {
      wrong(key ": " bytes " bytes, more than " limit[key])
    }
  }
}

function wrong(text) {
  print "check.awk: " text > "/dev/stderr"
  failed = 1
}
