# frames.awk NM DISASSEMBLY: the stack of every function in a linked program, from its machine code.
#
# Follows sp through each function along all branches until nothing changes: pushes, stores that
# move sp, `sub sp`, and what undoes them; Thumb and RISC-V. Prints
#     frame NAME BYTES             the lowest it sets sp
#     call NAME CALLEE BYTES       how low sp is at a call, the deepest of several; 0 at most tail
#                                  calls, which give the frame back first
#     trouble NAME WHAT            what it can't follow: sp set from a register, code nobody reaches
# A function of several names has its lines under each, as caller and as callee.

FILENAME == ARGV[1] {  # address type name
  sub(/^0+/, "", $1)
  if ($2 ~ /^[tTwW]$/ && $3 !~ /^\$/) {
    names[$1] = names[$1] " " $3
    home[$3] = $1
  }
  next
}

/^[0-9a-f]+ <.*>:$/ {
  finish()
  address = $1
  sub(/^0+/, "", address)
  name = $2
  gsub(/[<>:]/, "", name)
  next
}
name != "" && /^ *[0-9a-f]+:/ {
  split($0, part, "\t")
  sub(/ *[;@#] .*$/, "", part[4])
  sub(/\.[nw]$/, "", part[3])
  gsub(/[ :]/, "", part[1])
  ++length_
  at[length_] = part[1]
  operation[length_] = part[3]
  operands[length_] = part[4]
  mine[part[1]] = 1
}
END { finish() }

function deeper(a, b) {
  return a > b ? a : b
}

# All of one function. Depths only grow and frames are finite, so the passes end; a loop that pushes
# would not, hence the limit.
function finish(pass, list, n, i, callee) {
  if (name == "") {
    return
  }
  lowest = 0
  trouble = ""
  spread = -1
  split("", expected)
  split("", calls)
  changed = 1
  for (pass = 1; changed; ++pass) {
    changed = 0
    walk()
    if (pass == 20) {
      trouble = "its depth has no end"
      break
    }
  }
  n = split((address in names) ? names[address] : name, list, " ")
  for (i = 1; i <= n; ++i) {
    print "frame", list[i], lowest
    for (callee in calls) {
      print "call", list[i], callee, calls[callee]
    }
    if (trouble != "") {
      print "trouble", list[i], trouble
    }
  }
  length_ = 0
  split("", mine)
  name = ""
}

function walk(i, unreached) {
  depth = 0
  lost = 0
  unreached = ""
  for (i = 1; i <= length_; ++i) {
    if (at[i] in expected) {
      depth = lost ? expected[at[i]] : deeper(depth, expected[at[i]])
      lost = 0
    } else if (lost && spread >= 0 && !is_padding(i)) {
      depth = spread  # a case of the computed branch
      lost = 0
    }
    if (lost) {
      unreached = is_padding(i) ? unreached : at[i]
      continue
    }
    follow(operation[i], operands[i])
    lowest = deeper(lowest, depth)
  }
  if (!changed && unreached != "") {
    trouble = "nothing leads to " unreached
  }
}

# Between functions; and a return, which takes no stack whoever gets there.
function is_padding(i) {
  return operation[i] ~ /^(nop|unimp|\.)/ ||
    operation[i] " " operands[i] ~ /^(movs r0, r0|bx lr|ret ?)$/
}

# Bytes of a list of registers: {r4, r5-r7, lr}, {d8-d9}.
function registers(list, n, i, item, range, count) {
  sub(/^.*\{/, "", list)
  sub(/\}.*$/, "", list)
  n = split(list, item, /, */)
  for (i = 1; i <= n; ++i) {
    count += split(item[i], range, "-") == 2 ? number(range[2]) - number(range[1]) + 1 : 1
  }
  return count * (list ~ /^d/ ? 8 : 4)
}
function number(register) {
  if (register in special) {
    return special[register]
  }
  sub(/^[a-z]+/, "", register)
  return register + 0
}
BEGIN {
  special["sl"] = 10
  special["fp"] = 11
  special["ip"] = 12
}

# The number behind the last comma.
function constant(text) {
  sub(/^.*[#,]/, "", text)
  return text + 0
}

function follow(what, with) {
  if (what ~ /^v?push$/ || (what ~ /^v?stmdb$/ && with ~ /^sp!/)) {
    depth += registers(with)
  } else if (what ~ /^v?pop$/ || (what ~ /^v?ldmia$/ && with ~ /^sp!/)) {
    depth -= registers(with)
    lost = with ~ /pc/
  } else if (what ~ /^v?str/ && with ~ /\[sp, #-[0-9]+\]!/) {
    sub(/\]!.*$/, "", with)
    depth -= constant(with)
  } else if (what ~ /^v?ldr/ && with ~ /\[sp\], #[0-9]+/) {
    depth -= constant(with)
    lost = with ~ /^pc/
  } else if (what ~ /^(sub|add)[ws]?$/ && with ~ /^sp, /) {
    move(with ~ /#/, what ~ /^sub/ ? constant(with) : -constant(with), with)
  } else if (what ~ /^addi?$/ && with ~ /^sp,sp,-?[0-9]+$/) {
    move(1, -constant(with), with)
  } else if (with ~ /^sp(!?|,.*)$/ && what !~ /^(cmp|v?st|v?ld)/ || with ~ /^sp!/) {
    move(0, 0, what " " with)
  } else {
    go(what, with)
  }
}

function move(is_constant, bytes, text) {
  depth += bytes
  if (!is_constant) {
    trouble = "sets sp from a register: " text
  }
}

function go(what, with) {
  if (what ~ /^(bl|jal)$/ && target_of(with) in mine && target_of(with) != at[1]) {
    branched(with)  # Thumb's far jump, where lr is saved
    lost = 1
  } else if (what ~ /^(bl|jal|blx|jalr|call)$/) {
    called(with)
    if (with ~ /__gnu_thumb1_case_/) {
      leave_computed()
    }
  } else if (what ~ /^(ret|mret|udf|ebreak|j|b|bx|jr|tail)$/) {
    if (with ~ /</) {
      branched(with)
    } else if (what ~ /^(bx|jr)$/ && with !~ /^(lr|ra)$/) {
      called(with)
    }
    lost = 1
  } else if (what ~ /^tb[bh]$/ || with ~ /^pc, /) {
    leave_computed()
  } else if (what ~ /^c?b/ && with ~ /</) {
    branched(with)
  }
}

# Where to is a table's business: any code that nothing else leads to.
function leave_computed() {
  if (depth > spread) {
    spread = depth
    changed = 1
  }
  lost = 1
}

# Of "1a2 <name+0x12>", maybe behind registers.
function target_of(with) {
  sub(/ *<.*$/, "", with)
  sub(/^.*[, \t]/, "", with)
  return with
}

# On in this function, or a call of another one that does not come back.
function branched(to, target) {
  target = target_of(to)
  if (!(target in mine)) {
    called(to)
  } else if (!(target in expected) || expected[target] < depth) {
    expected[target] = depth
    changed = 1
  }
}

function called(to, target, list, n, i) {
  target = target_of(to)
  if (to !~ /</) {
    to = "__indirect_call"
  }
  sub(/^[^<]*</, "", to)
  sub(/[+>].*$/, "", to)
  target = target in names ? target : (to in home) ? home[to] : ""
  n = split(target == "" ? to : names[target], list, " ")
  for (i = 1; i <= n; ++i) {
    calls[list[i]] = (list[i] in calls) ? deeper(calls[list[i]], depth) : depth
  }
}
