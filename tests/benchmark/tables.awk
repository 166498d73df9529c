# See tables.sh. A walk or a query is known by its core, setup and algorithm; all by number.
$1 == "core" && !($2 in core_number) {
  core_number[$2] = cores + 0
  core_name[cores++] = $2
}
$1 == "core" {
  core = core_number[$2]
}

# What the cores have to agree about.
function same(kind, setup, algorithm, counts,    key) {
  key = kind SUBSEP setup SUBSEP algorithm
  if (key in known && known[key] != counts) {
    print "tables.sh: the cores differ: " name[setup] ", " algorithm > "/dev/stderr"
    failed = 1
  }
  known[key] = counts
}

$1 == "row" || $1 == "query" || $1 == "left_out" {
  setup = number("number")
  setups = setup >= setups ? setup + 1 : setups
  table[setup] = number("table")
  title[setup] = text("title")
  name[setup] = text("setup")
  algorithm = text("algorithm")
}

$1 == "left_out" {
  left_out[core] = left_out[core] "\n- table " table[setup] ", " name[setup]
}

$1 == "row" {
  if (!(algorithm in is_algorithm)) {
    is_algorithm[algorithm] = 1
    algorithms[algorithm_count++] = algorithm
  }
  measured[setup] = 1
  faces[setup] = number("faces_a") " and " number("faces_b") " faces"
  visits[setup, algorithm] = number("visits")
  overlaps[setup, algorithm] = number("overlaps")
  leaf_overlaps[setup, algorithm] = number("leaf_overlaps")
  walk[core, setup, algorithm] = number("instructions")
  same("row", setup, algorithm, number("visits") " " number("overlaps") " " number("leaf_overlaps"))
}

$1 == "query" {
  geometry_overlaps[setup] = number("geometry_overlaps")
  query[core, setup, algorithm] = number("instructions")
  same("query", setup, algorithm, number("visits") " " number("geometry_overlaps"))
}

function quotient(part, whole, digits) {
  return sprintf("%.*f", digits, part / whole)
}

function core_cells(instructions, iterations, volume) {
  if (instructions + 0 == 0) {
    cell("-"); cell("-"); cell("-")
    return
  }
  cell(instructions)
  cell(quotient(instructions, iterations, 1))
  cell(quotient(instructions, volume, 3))
}

function core_heads(    c) {
  for (c = 0; c < cores; ++c) {
    cell(core_name[c])
    cell("per iteration")
    cell("of volume-stack")
  }
  end_row()
}

function print_setup(setup,    i, c, algorithm, volume) {
  printf "**%s** (%s, %s geometry overlaps; instructions)\n\n", name[setup], faces[setup],
    geometry_overlaps[setup]
  begin_table()
  cell("algorithm"); cell("iterations"); cell("overlaps"); cell("leaf overlaps")
  core_heads()
  for (i = 0; i < algorithm_count; ++i) {
    algorithm = algorithms[i]
    cell(algorithm)
    cell(visits[setup, algorithm])
    cell(overlaps[setup, algorithm])
    cell(leaf_overlaps[setup, algorithm])
    for (c = 0; c < cores; ++c) {
      volume = walk[c, setup, "volume-stack"]
      core_cells(walk[c, setup, algorithm], visits[setup, algorithm], volume)
    }
    end_row()
  }
  print_table()
}

# Over the setups of more than ten iterations that the core has.
function counts_for(c, setup) {
  return walk[c, setup, "ranked"] != "" && visits[setup, "ranked"] > 10
}

function sum_instructions(c, algorithm,    setup, sum) {
  for (setup = 0; setup < setups; ++setup) {
    sum += counts_for(c, setup) ? walk[c, setup, algorithm] : 0
  }
  return sum
}

function sum_iterations(c, algorithm,    setup, sum) {
  for (setup = 0; setup < setups; ++setup) {
    sum += counts_for(c, setup) ? visits[setup, algorithm] : 0
  }
  return sum
}

function print_totals(    i, c) {
  print "### All setups of more than ten iterations: boxes\n"
  begin_table()
  cell("instructions")
  core_heads()
  for (i = 0; i < algorithm_count; ++i) {
    cell(algorithms[i])
    for (c = 0; c < cores; ++c) {
      core_cells(sum_instructions(c, algorithms[i]), sum_iterations(c, algorithms[i]),
        sum_instructions(c, "volume-stack"))
    }
    end_row()
  }
  print_table()
  print_bounds()
}

# The largest part of volume-stack's instructions that ranked takes in any setup, and the part of
# ranked-stack's.
function print_bounds(    c, setup, part, worst, where) {
  begin_table()
  cell("instructions of ranked"); cell("of ranked-stack's, in total")
  cell("of volume-stack's, at most"); cell("in"); end_row()
  for (c = 0; c < cores; ++c) {
    if (!sum_instructions(c, "ranked")) {
      continue
    }
    worst = 0
    for (setup = 0; setup < setups; ++setup) {
      part = counts_for(c, setup) ? walk[c, setup, "ranked"] / walk[c, setup, "volume-stack"] : 0
      if (part > worst) {
        worst = part
        where = name[setup]
      }
    }
    cell(core_name[c])
    cell(quotient(sum_instructions(c, "ranked"), sum_instructions(c, "ranked-stack"), 3))
    cell(quotient(worst, 1, 3)); cell(where); end_row()
  }
  print_table()
}

function print_queries(    c, setup) {
  print "### Whole queries, triangles and all\n"
  begin_table()
  cell("instructions"); cell("iterations of ranked"); cell("leaf overlaps")
  cell("geometry overlaps")
  for (c = 0; c < cores; ++c) {
    cell(core_name[c] ", volume-stack"); cell("ranked"); cell("ranked / volume")
  }
  end_row()
  for (setup = 0; setup < setups; ++setup) {
    if (measured[setup]) {
      print_query(setup)
    }
  }
  print_table()
}

function print_query(setup,    c, ranked, volume) {
  cell("table " table[setup] ", " name[setup])
  cell(visits[setup, "ranked"])
  cell(leaf_overlaps[setup, "ranked"])
  cell(geometry_overlaps[setup])
  for (c = 0; c < cores; ++c) {
    ranked = query[c, setup, "ranked"]
    volume = query[c, setup, "volume-stack"]
    cell(volume == "" ? "-" : volume)
    cell(ranked == "" ? "-" : ranked)
    cell(ranked == "" ? "-" : quotient(ranked, volume, 3))
  }
  end_row()
}

END {
  for (setup = 0; setup < setups; ++setup) {
    if (measured[setup]) {
      if (table[setup] != last_table) {
        printf "### Table %d: %s\n\n", table[setup], title[setup]
        last_table = table[setup]
      }
      print_setup(setup)
    }
  }
  print_totals()
  print_queries()
  for (c = 0; c < cores; ++c) {
    if (left_out[c] != "") {
      print "Too large for the flash of the board with " core_name[c] ":\n" left_out[c] "\n"
    }
  }
  exit failed + 0
}
