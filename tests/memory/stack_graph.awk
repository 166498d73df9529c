# stack_graph.awk ROOTS CALLS FRAMES CI...: the worst case of each root's stack.
#
# CI: what -fcallgraph-info=su writes: a node for each function with its frame, an edge for each
# call. FRAMES, from frames.awk, is the linked machine code's word on the same. It must give each
# function the frame that the compiler gives, and has what the compiler does not tell: the stack of
# libgcc, and which calls are tail calls, below which the caller's frame is gone.
#
# CALLS (calls.txt) names what is no plain call of a function compiled here. Recursion, a frame of
# no fixed size, an indirect call or an unknown function that it does not name are errors.
#
# A function that several sources have, a template's instance, has the largest of their frames and
# all of their calls. Prints, in the order of ROOTS,
#     stack ROOT graph BYTES
#     path ROOT FUNCTION BYTES > ...    what each function on the deepest path holds
FNR == 1 { ++file }
/^#/ || /^$/ { next }
file == 1 { roots[++root_count] = $1; next }
file == 2 { read_table(); next }
file == 3 { read_frame(); next }
/^node:/ { read_node(); next }
/^edge:/ { read_edge() }

END {
  for (i = 1; i <= root_count; ++i) {
    root = roots[i]
    if (!(root in frame)) {
      error("no such function: " root)
      continue
    }
    split("", depth)
    split("", deepest)
    print "stack", root, "graph", depth_of(root)
    if (failed) {
      continue  # there may be no end to the path
    }
    path = ""
    for (f = root; f != ""; f = deepest[f]) {
      path = path (path == "" ? "" : " > ") f " " own(f)
    }
    print "path", root, path
  }
  exit failed
}

function error(text) {
  if (text in told) {
    return
  }
  told[text] = 1
  print "stack_graph.awk: " text > "/dev/stderr"
  failed = 1
}

function read_table() {
  if ($1 == "outside") {
    outside = outside (outside == "" ? "^(" : "|") $2
  } else if ($1 == "assembly") {
    if (index("," tags ",", "," $4 ",")) {
      assembly[$2] = $3
    }
  } else if ($1 == "visitor") {
    visitor[$2] = 1
  } else if ($1 == "never") {
    never[$2] = $3
  } else {
    error("not understood: " $0)
  }
}

function read_frame() {
  if ($1 == "frame") {
    code_frame[$2] = $3 > code_frame[$2] + 0 ? $3 : code_frame[$2] + 0
  } else if ($1 == "call") {
    code_calls[$2] = code_calls[$2] " " $3 " " $4
    at_call[$2, $3] = $4 > at_call[$2, $3] + 0 ? $4 : at_call[$2, $3] + 0
    add_edge($2, $3)
  } else {
    trouble[$2] = $0
  }
}

# The mangled name; a local function's has its file before it.
function title(label, text) {
  text = $0
  sub("^.*" label ": \"", "", text)
  sub(/".*$/, "", text)
  sub(/^.*:/, "", text)
  sub(/^[*]/, "", text)  # a name that the source gave
  return text
}

function read_node(name, bytes) {
  name = title("title")
  if ($0 !~ / bytes \(/) {
    return
  }
  bytes = $0
  if (bytes !~ /bytes \(static\)/) {
    error(name " has a frame of no fixed size")
  }
  sub(/ bytes \(.*$/, "", bytes)
  sub(/^.*n/, "", bytes)
  frame[name] = (name in frame) && frame[name] > bytes + 0 ? frame[name] : bytes + 0
}

function read_edge() {
  add_edge(title("sourcename"), title("targetname"))
}

function add_edge(from, to) {
  if (!((from, to) in is_edge)) {
    is_edge[from, to] = 1
    edges[from] = edges[from] " " to
  }
}

# The function's own share, its callees' left out.
function own(name) {
  return name in assembly ? assembly[name] : name in frame ? frame[name] : depth[name]
}

function depth_of(name, list, n, i, below, most) {
  if (root in never && name ~ never[root]) {
    return 0
  }
  if (name in depth) {
    return depth[name]
  }
  if (name in on_path) {
    error("recursion through " name)
    return 0
  }
  on_path[name] = 1
  if (!(name in frame)) {
    if (outside == "" || name !~ (outside ")$")) {
      error("not in the table: " name)
      most = 0
    } else {
      most = code_depth(name)
    }
  } else {
    check_frame(name)
    most = own(name)
    n = split(edges[name], list, " ")
    for (i = 1; i <= n; ++i) {
      if (list[i] == "__indirect_call") {
        if (!(name in visitor)) {
          error("indirect call in " name)
        }
        continue
      }
      below = held(name, list[i]) + depth_of(list[i])
      if (below > most || (below == most && deepest[name] == "")) {
        most = below
        deepest[name] = list[i]
      }
    }
  }
  delete on_path[name]
  return depth[name] = most
}

# What the caller still holds of its frame at a call: nothing at a tail call.
function held(caller, callee) {
  return ((caller, callee) in at_call) ? at_call[caller, callee] : own(caller)
}

# By machine code alone.
function code_depth(name, list, n, i, below, most) {
  if (!(name in code_frame)) {
    error("not linked: " name)
    return 0
  }
  if (name in trouble) {
    error(trouble[name])
  }
  if (name in in_code) {
    error("recursion through " name)
    return 0
  }
  in_code[name] = 1
  most = code_frame[name]
  n = split(code_calls[name], list, " ")
  for (i = 1; i < n; i += 2) {
    below = list[i + 1] + code_depth(list[i])
    most = below > most ? below : most
  }
  delete in_code[name]
  return most
}

function check_frame(name) {
  if (name in trouble) {
    error(trouble[name])
  }
  if (!(name in code_frame)) {
    return  # inlined wherever it is called
  }
  if (own(name) != code_frame[name]) {
    error(name ": the machine code takes " code_frame[name] " bytes, not " own(name))
  }
}
