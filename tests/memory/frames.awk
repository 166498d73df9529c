# frames.awk NM DISASSEMBLY: the stack of every function in a linked program, from its machine code.
#
# Follows the stack pointer through each function, branch by branch: pushes, stores that move sp,
# `sub sp`, and what undoes them. Prints for each function
#     frame NAME BYTES                        the lowest it sets sp
#     call NAME CALLEE BYTES                  how low sp is when it calls; at a tail call, too
#     trouble NAME WHAT                       recognised nothing, or sp set from another register
# All names of an address, as libgcc has them, are printed; so are functions nobody calls.

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
  depth = lowest = 0
  split("", expected)
  lost = 0
  next
}
name == "" || $0 !~ /^ *[0-9a-f]+:/ { next }

{
  split($0, part, "\t")
  here = part[1]
  gsub(/[ :]/, "", here)
  operation = part[3]
  operands = part[4]
  sub(/ *[;@#] .*$/, "", operands)
  if (here in expected) {
    depth = lost ? expected[here] : deeper(depth, expected[here])
    lost = 0
  } else if (lost) {
    depth = 0  # a table of constants, or code that only a computed branch reaches
  }
  follow(operation, operands)
  lowest = deeper(lowest, depth)
}
END { finish() }

function deeper(a, b) {
  return a > b ? a : b
}

# Of a list of registers in braces: {r4, r5-r7, lr}, {d8-d9}.
function registers(list, n, i, item, range, count) {
  sub(/^.*\{/, "", list)
  sub(/\}.*$/, "", list)
  n = split(list, item, /, */)
  count = 0
  for (i = 1; i <= n; ++i) {
    if (split(item[i], range, "-") == 2) {
      count += number_of(range[2]) - number_of(range[1]) + 1
    } else {
      ++count
    }
  }
  return count * (list ~ /^d/ ? 8 : 4)
}
function number_of(register) {
  if (register == "sl") return 10
  if (register == "fp") return 11
  if (register == "ip") return 12
  sub(/^[a-z]+/, "", register)
  return register + 0
}
# The constant that follows #, or the last operand.
function constant(operands) {
  sub(/^.*[#,]/, "", operands)
  return operands + 0
}

function follow(operation, operands, to) {
  sub(/\.[nw]$/, "", operation)
  if (operation ~ /^(push|vpush)$/) {
    depth += registers(operands)
  } else if (operation ~ /^(stmdb|vstmdb)$/ && operands ~ /^sp!/) {
    depth += registers(operands)
  } else if (operation ~ /^str/ && operands ~ /\[sp, #-[0-9]+\]!/) {
    to = operands
    sub(/^.*#-/, "", to)
    depth += to + 0
  } else if (operation ~ /^(sub|subw|subs)$/ && operands ~ /^sp, /) {
    moved(operands, 1)
  } else if (operation ~ /^(add|addw|adds)$/ && operands ~ /^sp, /) {
    moved(operands, -1)
  } else if (operation == "addi" && operands ~ /^sp,sp,/) {
    depth -= constant(operands)
  } else if (operation ~ /^(pop|vpop)$/) {
    depth -= registers(operands)
    lost = operands ~ /pc/
  } else if (operation ~ /^(ldmia|vldmia)$/ && operands ~ /^sp!/) {
    depth -= registers(operands)
    lost = operands ~ /pc/
  } else if (operation ~ /^ldr/ && operands ~ /\[sp\], #[0-9]+/) {
    depth -= constant(operands)
    lost = operands ~ /^pc/
  } else if (operation ~ /^(mov|li|lui|mv)$/ && operands ~ /^sp,/) {
    print "trouble", name, "sets sp: " operation " " operands
  } else if (operation ~ /^(bl|jal|call)$/) {
    called(operands)
  } else if (operation ~ /^(blx|jalr)$/) {
    if (operands !~ /</) {
      print "call", name, "__indirect_call", depth
    } else {
      called(operands)
    }
  } else if (operation ~ /^(bx|ret|jr|mret|udf|ebreak)$/) {
    if (operation ~ /^(bx|jr)$/ && operands !~ /^(lr|ra)$/) {
      print "call", name, "__indirect_call", depth
    }
    lost = 1
  } else if (operation ~ /^(tbb|tbh)$/) {
    spread = depth  # each case goes on from here
  } else if (operation ~ /^(b|j|c?b[a-z]+|beqz|bnez)$/ && operands ~ /</) {
    branched(operation, operands)
  }
}

function moved(operands, sign) {
  if (operands !~ /#/) {
    print "trouble", name, "sets sp by a register: " operands
    return
  }
  depth += sign * constant(operands)
}

# A destination "1a2 <name+0x12>" inside this function is where the depth goes on, any other a call.
function branched(operation, operands, to, target) {
  to = operands
  if (index(to, "<" name "+") || index(to, "<" name ">")) {
    target = to
    sub(/ *<.*$/, "", target)
    sub(/^.*[, ]/, "", target)
    expected[target] = (target in expected) ? deeper(expected[target], depth) : depth
  } else {
    called(operands)
  }
  if (operation == "b" || operation == "j") {
    lost = 1
  }
}

# Under all names of the callee.
function called(operands, to, list, n, i) {
  to = operands
  sub(/^[^<]*</, "", to)
  sub(/[+>].*$/, "", to)
  n = split((to in home) ? names[home[to]] : to, list, " ")
  for (i = 1; i <= n; ++i) {
    calls[++call_count] = list[i] " " depth
  }
}

function finish(list, n, i, j) {
  if (name == "") {
    return
  }
  n = split(names[address], list, " ")
  if (n == 0) {
    n = 1
    list[1] = name
  }
  for (i = 1; i <= n; ++i) {
    print "frame", list[i], lowest
    for (j = 1; j <= call_count; ++j) {
      print "call", list[i], calls[j]
    }
  }
  call_count = 0
  name = ""
}
