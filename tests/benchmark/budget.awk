# See budget.sh.
$1 == "row" {
  setup = number("number")
  algorithm = text("algorithm")
  setups = setup >= setups ? setup + 1 : setups
  name[setup] = text("setup")
  visits[setup, algorithm] = number("visits")
  instructions[setup, algorithm] = number("instructions")
}

$1 == "query" && text("algorithm") == "ranked" && number("visits") == 1 {
  separated[number("number")] = number("instructions")
}

# `strict`: below the limit; else at most.
function report(what, figure, digits, strict,    kept) {
  kept = strict ? figure < limit + 0 : figure <= limit + 0
  printf "%s: %.*f, budget: %s %s%s\n", what, digits, figure, strict ? "below" : "at most", limit,
    kept ? "" : ": NOT KEPT"
  ++figures
  failures += !kept
}

function total(of, algorithm,    setup, sum) {
  for (setup = 0; setup < setups; ++setup) {
    if (visits[setup, "ranked"] > 10) {
      sum += of[setup, algorithm]
    }
  }
  return sum
}

function report_of_volume_stack(    setup) {
  for (setup = 0; setup < setups; ++setup) {
    if (visits[setup, "ranked"] > 10) {
      report(name[setup], instructions[setup, "ranked"] / instructions[setup, "volume-stack"], 3, 1)
    }
  }
}

function report_separated(    setup) {
  for (setup = 0; setup < setups; ++setup) {
    if (setup in separated) {
      report(name[setup], separated[setup], 0, 0)
    }
  }
}

END {
  ranked = total(instructions, "ranked")
  if (what ~ /^per-visit=/ && ranked) {
    algorithm = substr(what, length("per-visit=") + 1)
    if (total(visits, algorithm)) {
      report("instructions of " algorithm " per visit",
        total(instructions, algorithm) / total(visits, algorithm), 2, 0)
    }
  } else if (what == "of-ranked-stack" && ranked) {
    report("instructions of ranked as part of ranked-stack's",
      ranked / total(instructions, "ranked-stack"), 4, 0)
  } else if (what == "of-volume-stack") {
    report_of_volume_stack()
  } else if (what == "separated") {
    report_separated()
  }
  if (!figures) {
    print "no such figure in the results: " what
    exit 1
  }
  exit failures != 0
}
