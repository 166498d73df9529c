# turns.awk CUTS RUNS TRACE. RUNS: what the firmware printed.
#
# What counts is executed between the call of bound_run, bound_run_itself or bound_make_query and that
# of bound_done.
# Where the table has a number, it holds for each call; where it leaves it open, for each run: the
# k-th execution of either bound_run is the k-th line "run".
FNR == 1 { ++file }

file == 1 && $1 == "symbol" { symbol[$2] = $3 }

file == 1 && $1 == "cut" {
  entry_of[$2] = $3
  kind_of[$2] = $4
  limit[$2] = $5
  at_entry[$3] = at_entry[$3] " " $2
}

# run KIND WORK VISITS LEAF_PAIRS DEPTHS LEAF_SIZE INSTRUCTIONS. Two sides of a walk have two
# children a node, and the last one's look finds none.
file == 2 && $1 == "run" {
  ++runs
  walks = $5 + 1
  pairs = int(($3 + 31) / 32)
  shapes = int(($3 + 7) / 8) + 1
  turns = walks + shapes + ($4 < $3 / 2 ? $4 : int($3 / 2))
  of_run[runs, "visit"] = $4 + 2 * walks + turns
  of_run[runs, "turn"] = turns
  of_run[runs, "sibling"] = 8 * walks
  of_run[runs, "row"] = of_run[runs, "triangle"] = pairs
  of_run[runs, "other"] = 2 * ($7 - 1) * shapes
  of_run[runs, "test"] = pairs + walks + 2
  of_run[runs, "ascent"] = $6 + $4
  of_run[runs, "skipped"] = 2 * of_run[runs, "ascent"]
  of_run[runs, "corner"] = 6 * pairs
  of_run[runs, "climb"] = $6 + $4 + turns
}

function over(what, count, most) {
  print "executed " count " times, not at most " most ": " what
  ++failures
}

function end_run(    kind) {
  for (kind in in_run) {
    if (in_run[kind] > of_run[traced, kind]) {
      over(kind " in run " traced, in_run[kind], of_run[traced, kind])
    }
    all[kind] += in_run[kind]
    all_allowed[kind] += of_run[traced, kind]
  }
  split("", in_run)
}

# QEMU takes back a block that it logged, but did not execute.
file == 3 {
  if (/^Trace/) {
    execute(last)
    split($0, part, "/")
    last = part[2]
    sub(/^0+/, "", last)
  } else if (/^Stopped/) {
    last = ""
  }
}

function execute(at,    i, n, inside) {
  if (at in symbol) {
    counts = symbol[at] != "bound_done"
    if (symbol[at] ~ /^bound_run/) {
      end_run()
      ++traced
    }
  }
  if (at in at_entry) {
    n = split(at_entry[at], inside, " ")
    for (i = 1; i <= n; ++i) {
      count[inside[i]] = 0
    }
  }
  if (counts && at in kind_of) {
    ++count[at]
    if (limit[at] < 0) {
      ++in_run[kind_of[at]]
    } else if (count[at] > limit[at]) {
      over(kind_of[at] " at " at, count[at], limit[at])
    }
    if (count[at] > most[at]) {
      most[at] = count[at]
    }
  }
}

END {
  execute(last)
  end_run()
  for (kind in all) {
    printf "%s: %d in all runs, at most %d\n", kind, all[kind], all_allowed[kind] | "sort"
  }
  for (at in limit) {
    if (limit[at] >= 0) {
      printf "%s at %s: %d a call, at most %d\n", kind_of[at], at, most[at], limit[at] | "sort"
    }
  }
  close("sort")
  if (traced != runs || runs < 1000) {
    print traced + 0 " runs traced, " runs + 0 " measured"
    ++failures
  }
  exit failures != 0
}
