# shipped.awk BOUND HEADER: fails unless the constants of HEADER, flashbvh/detail/run_costs.hpp, are
# those that prove.py wrote to BOUND. BOUND may be tests/figures/figures.txt, which has all cores.
#
# With -v write=1: prints what HEADER has to be instead, with all else of it as it is.
FILENAME == ARGV[1] {
  if ($1 == "core") {
    core = $2
  } else if ($1 == "bound") {
    proven[core, $2] = $3
    is_proven[core] = 1
  } else if (sub(/^bound\./, "", $2)) {
    proven[$1, $2] = $3
    is_proven[$1] = 1
  }
  next
}

function constants(core) {
  return sprintf("constexpr RunCosts k%s = {%d, %d, %d, %d, %d};", named(core), proven[core, "start"],
    proven[core, "ascent"], proven[core, "later-sibling"], proven[core, "leaf-triangle"],
    proven[core, "work"])
}

function named(core) {
  gsub(/-/, "", core)
  return core
}

# Sorted, as they come from figures.txt.
/^constexpr RunCosts/ {
  if (write) {
    if (!written++) {
      while (("sort " ARGV[1]) | getline line) {
        split(line, field, " ")
        if (field[2] == "bound.start") {
          print constants(field[1])
        }
      }
    }
    next
  }
  shipped[$3] = $0
}
write { print }

END {
  for (core in is_proven) {
    ++cores
    if (!write && shipped["k" named(core)] != constants(core)) {
      print "shipped: " shipped["k" named(core)]
      print "proven:  " constants(core)
      print "run tools/figures.sh"
      failed = 1
    }
  }
  if (!cores) {
    print "shipped.awk: nothing proven" > "/dev/stderr"
    failed = 1
  }
  exit failed
}
