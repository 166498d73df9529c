# The most instructions that a function can execute: the longest path of its control-flow graph,
# calls included. See longest_path.sh.
#
# Loops are cut where an instruction belongs to a line of the source that the table names: every
# cycle of the graph passes a cut. Between two cuts the graph has no cycle, and a longest path is
# found in topological order, by Kahn. Paths from cut to cut form a graph of a few nodes. A path
# leaves each of its strongly connected components once; inside, it makes as many steps from cuts of
# a kind as the table grants. So, with n(k) steps from kind k and inside(k) the longest of them,
#     instructions <= fixed + sum over k of n(k) * inside(k)
# where `fixed` is the longest path from the entry to a return that steps from component to
# component. That holds for irreducible loops, too.
#
# Needs: disassembly.awk, table.awk, arm.awk or riscv.awk; FUNCTIONS in the environment.

# weight[i]: the instruction and what it calls; edges[i]: indices behind it, by blanks.
function read_graph(f,    i) {
  split("", weight)
  split("", edges)
  split("", exits)
  for (i = first_of[f]; i <= last_of[f]; ++i) {
    if (!(i in reachable)) {
      continue
    }
    flow_of(i)
    weight[i] = 1
    edges[i] = ""
    exits[i] = leaves
    if (call) {
      weight[i] += cost_of(owner[call], f)
    }
    if (jump && owner[jump] != f) {  # a call in tail position
      weight[i] += cost_of(owner[jump], f)
      exits[i] = 1
    } else if (jump) {
      edges[i] = jump
    }
    if (goes_on) {
      edges[i] = edges[i] " " (i + 1)
    }
  }
}

# Calls are costed before any of the caller's arrays is in use: awk has no local ones.
function find_reachable(f,    pending, i, n) {
  split("", reachable)
  n = 1
  pending[1] = first_of[f]
  reachable[first_of[f]] = 1
  while (n > 0) {
    i = pending[n--]
    flow_of(i)
    if (jump && owner[jump] == f && !(jump in reachable)) {
      reachable[jump] = 1
      pending[++n] = jump
    }
    if (goes_on && i == last_of[f]) {
      refuse(i, "the function's end is reached")
    }
    if (goes_on && !(i + 1 in reachable)) {
      reachable[i + 1] = 1
      pending[++n] = i + 1
    }
  }
}

# Kahn: order[1..n] of all reachable instructions, edges into cuts left out. False if a cycle
# remains; then left_over is an instruction on or behind it.
function sort_topologically(f,    i, k, n, head, to, into) {
  for (i in weight) {
    into[i] += 0
    n = split(edges[i], to, " ")
    for (k = 1; k <= n; ++k) {
      if (!(to[k] in cut)) {
        ++into[to[k]]
      }
    }
  }
  ordered = 0
  for (i = first_of[f]; i <= last_of[f]; ++i) {
    if (i in weight && into[i] == 0) {
      order[++ordered] = i
    }
  }
  for (head = 1; head <= ordered; ++head) {
    n = split(edges[order[head]], to, " ")
    for (k = 1; k <= n; ++k) {
      if (!(to[k] in cut) && --into[to[k]] == 0) {
        order[++ordered] = to[k] + 0
      }
    }
  }
  for (i = first_of[f]; i <= last_of[f]; ++i) {
    if (into[i] > 0) {
      left_over = i
      return 0
    }
  }
  return 1
}

# As few cuts as do: of instructions that do the same, a call stays, or the last.
function choose_cuts(f,    i) {
  split("", cut)
  for (i in marked) {
    if (i in weight) {
      cut[i] = marked[i]
    }
  }
  if (!sort_topologically(f)) {
    refuse(left_over, "a loop without a bound in " table)
  }
  for (i = first_of[f]; i <= last_of[f]; ++i) {
    if (i in cut && weight[i] == 1) {
      spare(f, i)
    }
  }
  for (i = first_of[f]; i <= last_of[f]; ++i) {
    if (i in cut) {
      spare(f, i)
    }
  }
  sort_topologically(f)
}

# Takes a cut away unless it is needed.
function spare(f, i,    kind) {
  kind = cut[i]
  delete cut[i]
  if (!sort_topologically(f)) {
    cut[i] = kind
  }
}

# step[from, to]: the longest path from one cut (or "in", the entry) to before another, or "out".
function measure_steps(f, from, start,    i, k, n, to, far, x) {
  far[start] = weight[start]
  for (k = 1; k <= ordered; ++k) {
    i = order[k]
    if (!(i in far)) {
      continue
    }
    if (exits[i] && far[i] > step[from, "out"]) {
      step[from, "out"] = far[i]
    }
    n = split(edges[i], to, " ")
    for (x = 1; x <= n; ++x) {
      if (to[x] in cut) {
        if (far[i] > step[from, to[x]]) {
          step[from, to[x]] = far[i]
        }
      } else if (far[i] + weight[to[x]] > far[to[x]]) {
        far[to[x]] = far[i] + weight[to[x]]
      }
    }
  }
}

# reach[i, j]: whether a path leads from cut i to cut j.
function close_reach(    i, j, k) {
  split("", reach)
  for (i in cut) {
    for (j in cut) {
      if (step[i, j] > 0) {
        reach[i, j] = 1
      }
    }
  }
  for (k in cut) {
    for (i in cut) {
      for (j in cut) {
        if ((i, k) in reach && (k, j) in reach) {
          reach[i, j] = 1
        }
      }
    }
  }
}

# The longest way from a cut's component out of the function, steps inside the component apart.
function way_out(i,    j, k, best, way) {
  if (i in known_way) {
    return known_way[i]
  }
  best = -1
  for (j in cut) {
    if (j != i && !((i, j) in reach && (j, i) in reach)) {
      continue
    }
    if (step[j, "out"] > best) {
      best = step[j, "out"]
    }
    for (k in cut) {
      if (step[j, k] > 0 && !((k, j) in reach)) {
        way = way_out(k)
        if (way >= 0 && step[j, k] + way > best) {
          best = step[j, k] + way
        }
      }
    }
  }
  return known_way[i] = best
}

# A kind with a number may be cut in one place of a loop only: in two, one turn might count twice.
function check_cuts(    i, j) {
  for (i in cut) {
    for (j in cut) {
      if (i != j && cut[i] == cut[j] && limit[cut[i]] >= 0 && (i, j) in reach && (j, i) in reach) {
        refuse(i, "a loop that " table " cuts in two places")
      }
    }
  }
}

# Sets fixed and, for each kind of cut and component, inside[kind, component].
function add_up(f,    i, j, component, way) {
  split("", inside)
  split("", known_way)
  fixed = step["in", "out"] + 0
  for (i in cut) {
    component = i
    for (j in cut) {
      if (j + 0 < component + 0 && (i, j) in reach && (j, i) in reach) {
        component = j
      }
    }
    inside[cut[i], component] += 0
    for (j in cut) {
      if (step[i, j] > inside[cut[i], component] && (j, i) in reach) {
        inside[cut[i], component] = step[i, j]
      }
    }
    way = way_out(i)
    if (step["in", i] > 0 && way >= 0 && step["in", i] + way > fixed) {
      fixed = step["in", i] + way
    }
  }
}

function cost_callees(f,    i, list, n, k) {
  find_reachable(f)
  n = 0
  for (i in reachable) {
    flow_of(i)
    if (call) {
      list[++n] = owner[call]
    }
    if (jump && owner[jump] != f) {
      list[++n] = owner[jump]
    }
  }
  for (k = 1; k <= n; ++k) {
    cost_of(list[k], f)
  }
}

# Adds a kind of cut to what is reported; what its turns beyond the first cost in all components.
function report_kind(f, kind,    i, sum, most) {
  most = -1
  for (i = first_of[f]; i <= last_of[f]; ++i) {
    if (kind in limit && (kind, i) in inside) {
      if (limit[kind] >= 0) {
        sum += (limit[kind] - 1) * inside[kind, i]
        report[f] = report[f] " " kind " " limit[kind] - 1 "*" inside[kind, i]
      } else if (inside[kind, i] > most) {
        most = inside[kind, i]
      }
    }
  }
  if (most >= 0) {
    open_kinds[f] = open_kinds[f] " " kind
    report[f] = report[f] " " kind " " most
  }
  return sum
}

# Of a whole call, or 0 if the table says that it is counted apart.
function cost_of(f, caller,    i, kind, sum, row) {
  if (f in cost) {
    if (cost[f] == "open") {
      print "longest_path: " f " calls itself" | "cat >&2"
      failed = 1
      exit 1
    }
    return cost[f]
  }
  cost[f] = "open"
  cost_callees(f)
  find_reachable(f)
  read_graph(f)
  read_marks(f)
  choose_cuts(f)
  for (i in cut) {
    cut_report = cut_report "cut " address[i] " " address[first_of[f]] " " cut[i] " " \
      limit[cut[i]] "\n"
  }
  split("", step)
  measure_steps(f, "in", first_of[f])
  for (i in cut) {
    measure_steps(f, i, i)
  }
  close_reach()
  check_cuts()
  add_up(f)
  sum = fixed
  report[f] = "fixed " fixed
  for (row = 1; row <= rows; ++row) {
    kind = row_kind[row]
    sum += report_kind(f, kind)
    delete limit[kind]  # two lines of the table may tell of one
  }
  if (f in open_kinds && !is_apart(f) && caller != "") {
    print "longest_path: " f " has no bound of its own (" open_kinds[f] "), but " caller \
      " calls it" | "cat >&2"
    failed = 1
    exit 1
  }
  report[f] = sum " = " report[f]
  return cost[f] = is_apart(f) ? 0 : sum
}

END {
  if (failed) {
    exit 1
  }
  read_table()
  wanted = split(ENVIRON["FUNCTIONS"], wanted_function, " ")
  for (w = 1; w <= wanted; ++w) {
    hits = 0
    for (f in first_of) {
      if (f ~ wanted_function[w]) {
        hit = f
        ++hits
      }
    }
    if (hits != 1) {
      print "longest_path: " hits " functions match " wanted_function[w] | "cat >&2"
      exit 1
    }
    cost_of(hit, "")
    print wanted_function[w] " " report[hit]
  }
  printf "%s", ENVIRON["CUTS"] ? cut_report : ""
}
