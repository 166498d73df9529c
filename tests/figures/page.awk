# awk -f markdown.awk -f formula.awk -f page.awk figures.txt parts.txt PAGE: the page, of its text and the data.
#
# Lines of the text that begin with @ become tables:
#     @table LABEL | HEAD...       the cores are the columns, after one for each HEAD
#     @row LABEL | NAME... | NAME  what all cores count under each HEAD; what each core takes
#     @end OTHERWISE               the table; if it has no rows, the rest of the line instead
#     @parts MOTION                what fits in a period of 1 ms, by part
#     @visits                      what bounds the visits of each pair of meshes, and the most observed
#     @bounded                     the worst queries observed on the links, beside the bounds on them
#     @leaf_sizes CORE NUMBER      what leaf sizes take, and what of them so many instructions are enough for
#     @worked CORE MOTION CLASS    the arithmetic of one of these figures
# and @{CORE NAME} in any other line the value. A row of which nothing is known is left out.

BEGIN {
  parts = cores = names = 0
}

FILENAME ~ /figures\.txt$/ {
  value[$1, $2] = $3
  if (!($2 in is_name)) {
    is_name[$2] = 1
    name[names++] = $2
  }
  if ($1 != "all" && !($1 in is_core)) {
    is_core[$1] = 1
    core[cores++] = $1
  }
  next
}

FILENAME ~ /parts\.txt$/ && $1 == "part" {
  part_core[parts] = $2
  part_mhz[parts] = $3
  part_name[parts] = $4 ($5 == "" ? "" : " " $5)
  ++parts
}

FILENAME ~ /parts\.txt$/ {
  if ($1 == "cycles_per_instruction") {
    cycles_per_instruction = $2
  }
  next
}

# With commas from 10,000 on.
function grouped(number,    head, tail) {
  if (number !~ /^[0-9]+$/ || number + 0 < 10000) {
    return number
  }
  head = number ""
  tail = ""
  while (length(head) > 3) {
    tail = "," substr(head, length(head) - 2) tail
    head = substr(head, 1, length(head) - 3)
  }
  return head tail
}

function shown(who, what) {
  return (who, what) in value ? grouped(value[who, what]) : "-"
}

# Two digits or three, or as many as the whole part has.
function rounded(number) {
  if (number >= 100) {
    return grouped(sprintf("%.0f", number))
  }
  return sprintf(number >= 10 ? "%.1f" : number >= 0.1 ? "%.2f" : "%.3f", number)
}

function trimmed(text) {
  gsub(/^ +| +$/, "", text)
  return text
}

function is_known(what,    c) {
  for (c = 0; c < cores; ++c) {
    if ((core[c], what) in value) {
      return 1
    }
  }
  return 0
}

function core_row(label, counts, count_names, what,    i, c) {
  if (!is_known(what)) {
    return
  }
  cell(label)
  for (i = 1; i <= counts; ++i) {
    cell(shown("all", count_names[i]))
  }
  for (c = 0; c < cores; ++c) {
    cell(shown(core[c], what))
  }
  end_row()
  ++rows
}

$1 == "@table" {
  heads = split(substr($0, length("@table") + 1), head, "|")
  begin_table()
  for (i = 1; i <= heads; ++i) {
    cell(trimmed(head[i]))
  }
  for (c = 0; c < cores; ++c) {
    cell(core[c])
  }
  end_row()
  rows = 0
  next
}

$1 == "@row" {
  fields = split(substr($0, length("@row") + 1), field, "|")
  for (i = 2; i < fields; ++i) {
    counted[i - 1] = trimmed(field[i])
  }
  core_row(trimmed(field[1]), fields - 2, counted, trimmed(field[fields]))
  next
}

$1 == "@end" {
  if (rows) {
    print_table()
  } else {
    otherwise = trimmed(substr($0, length("@end") + 1))
    printf "%s", otherwise == "" ? "" : otherwise "\n\n"
  }
  next
}

$1 == "@parts" {
  begin_table()
  cell("part"); cell("core"); cell("MHz"); cell("cycles"); cell("instructions"); cell("visits")
  split("separated small close intersecting", class, " ")
  for (i = 1; i <= 4; ++i) {
    cell(class[i])
  }
  cell("first pair")
  end_row()
  for (p = 0; p < parts; ++p) {
    if (part_core[p] in is_core) {
      part_row(p, $2)
    }
  }
  print_table()
  next
}

function part_row(p, motion,    who, instructions, i) {
  who = part_core[p]
  instructions = part_mhz[p] * 1000 / cycles_per_instruction
  cell(part_name[p]); cell(who); cell(part_mhz[p]); cell(grouped(part_mhz[p] * 1000))
  cell(grouped(sprintf("%.0f", instructions)))
  cell(rounded(instructions / value[who, "kr5.visit." motion ".mean"]))
  for (i = 1; i <= 4; ++i) {
    cell(rounded(instructions / value[who, "kr5.query." motion "." class[i] ".mean"]))
  }
  cell(rounded(instructions / value[who, "kr5.first." motion ".intersecting.mean"]))
  end_row()
}

$1 == "@visits" {
  begin_table()
  cell("pair of links"); cell("any traversal"); cell("`ranked`"); cell("most of 128 poses")
  end_row()
  for (i = 0; i < names; ++i) {
    if (name[i] ~ /^visits\..*\.observed$/) {
      pair = name[i]
      gsub(/^visits\.|\.observed$/, "", pair)
      link = pair
      sub(/-/, ", ", link)
      cell(link); cell(shown("all", "visits." pair ".any"))
      cell(shown("all", "visits." pair ".ranked")); cell(shown("all", name[i]))
      end_row()
    }
  }
  print_table()
  next
}

# Sets `cost` to what prove.py wrote.
function costs_of(who, cost,    i, what) {
  for (i = 0; i < names; ++i) {
    if (name[i] ~ /^bound\./) {
      what = name[i]
      sub(/^bound\./, "", what)
      cost[what] = value[who, name[i]]
    }
  }
}

# Of the pairs of links; `of`: depths, siblings or leaf_size.
function most_of_pairs(of,    i, most) {
  for (i = 0; i < names; ++i) {
    if (name[i] ~ "^visits\\..*\\." of "$" && value["all", name[i]] > most) {
      most = value["all", name[i]]
    }
  }
  return most
}

# A query made and run to its end takes at most so much: by the most work of the class.
function bound_of_query(who, motion, of_class,    cost) {
  costs_of(who, cost)
  return cost["make-query"] + most_instructions(cost, most_of_pairs("depths"),
    most_of_pairs("siblings"), most_of_pairs("leaf_size"),
    value["all", "kr5.work." motion "." of_class ".max"])
}

$1 == "@leaf_sizes" {
  costs_of($2, cost)
  begin_table()
  split("triangles a leaf|bytes a triangle|two leaves, at most|work in " grouped($3) \
    "|close, mean|most|intersecting, mean|most", head, "|")
  for (i = 1; i <= 8; ++i) {
    cell(head[i])
  }
  end_row()
  for (size = 1; size <= 8; ++size) {
    none = most_instructions(cost, most_of_pairs("depths"), most_of_pairs("siblings"), size, 0)
    each = most_instructions(cost, most_of_pairs("depths"), most_of_pairs("siblings"), size, 1) - none
    cell(size)
    cell(value["all", "leaf." size ".flash"])
    cell(32 * size * size)
    cell(int(($3 - none) / each))
    cell(shown("all", "leaf." size ".work.close.mean"))
    cell(shown("all", "leaf." size ".work.close.max"))
    cell(shown("all", "leaf." size ".work.intersecting.mean"))
    cell(shown("all", "leaf." size ".work.intersecting.max"))
    end_row()
  }
  print_table()
  next
}

function bounded_rows(motion, of_class,    c) {
  cell("B " motion ", " of_class ": at most")
  for (c = 0; c < cores; ++c) {
    cell(grouped(sprintf("%.0f", bound_of_query(core[c], motion, of_class))))
  }
  end_row()
  cell("observed")
  for (c = 0; c < cores; ++c) {
    cell(shown(core[c], "kr5.query." motion "." of_class ".max"))
  }
  end_row()
}

$1 == "@bounded" {
  begin_table()
  cell("the worst query observed, 64 poses")
  for (c = 0; c < cores; ++c) {
    cell(core[c])
  }
  end_row()
  bounded_rows("translated", "small")
  bounded_rows("translated", "close")
  bounded_rows("translated", "intersecting")
  bounded_rows("rotated", "small")
  bounded_rows("rotated", "close")
  bounded_rows("rotated", "intersecting")
  print_table()
  next
}

$1 == "@worked" {
  for (p = 0; part_core[p] != $2; ++p) {
    if (p == parts) {
      print "page.awk: no part with " $2 > "/dev/stderr"
      exit 1
    }
  }
  hertz = part_mhz[p] * 1000000
  per_period = hertz / 1000
  instructions = per_period / cycles_per_instruction
  query = value[$2, "kr5.query." $3 "." $4 ".mean"]
  printf "    %s Hz / 1,000 Hz = %s cycles a period of the loop\n", grouped(hertz), grouped(per_period)
  printf "    %s cycles / %s = %s instructions a period\n", grouped(per_period),
    cycles_per_instruction, grouped(sprintf("%.0f", instructions))
  printf "    %s / %s = %s queries a period (%s, %s, the mean)\n", grouped(sprintf("%.0f", instructions)),
    grouped(query), rounded(instructions / query), $3, $4
  if (query > instructions) {
    printf "    %s / %s = %s periods a query\n", grouped(query), grouped(sprintf("%.0f", instructions)),
      rounded(query / instructions)
  }
  visit = value[$2, "kr5.visit." $3 ".mean"]
  printf "    %s / %s = %s visits a period (%s)\n", grouped(sprintf("%.0f", instructions)), visit,
    rounded(instructions / visit), $3
  next
}

{
  while (match($0, /@\{[^}]*\}/)) {
    split(substr($0, RSTART + 2, RLENGTH - 3), asked, " ")
    if (!((asked[1], asked[2]) in value)) {
      print "page.awk: no figure " asked[1] " " asked[2] > "/dev/stderr"
      exit 1
    }
    $0 = substr($0, 1, RSTART - 1) shown(asked[1], asked[2]) substr($0, RSTART + RLENGTH)
  }
  print
}
