# Reads `objdump -dl --no-show-raw-insn`: instructions by index, in the order of their addresses.
#
#   address[i], mnemonic[i], operands[i]   as objdump writes them, comments left out
#   place[i]                               file:line of the source, as the debugger has it
#   owner[i]                               the function's symbol
#   first_of[function], last_of[function]  its range of indices
#   index_at[address]
/^[0-9a-f]+ <.*>:$/ {
  symbol = $2
  gsub(/^<|>:$/, "", symbol)
  line_now = ""
  next
}

/^[^ ].*:[0-9]+( \(discriminator [0-9]+\))?$/ {
  sub(/ \(discriminator [0-9]+\)$/, "")
  line_now = $0
  next
}

/^ *[0-9a-f]+:\t/ {
  count = split($0, part, "\t")
  ++instructions
  address[instructions] = part[1]
  gsub(/[ :]/, "", address[instructions])
  mnemonic[instructions] = part[2]
  operands[instructions] = count > 2 ? part[3] : ""
  sub(/ *[@#;] .*$/, "", operands[instructions])
  place[instructions] = line_now
  owner[instructions] = symbol
  if (!(symbol in first_of)) {
    first_of[symbol] = instructions
  }
  last_of[symbol] = instructions
  index_at[address[instructions]] = instructions
}

function refuse(i, why) {
  print "longest_path: " address[i] " in " owner[i] " (" place[i] "): " mnemonic[i] " " \
    operands[i] ": " why | "cat >&2"
  close("cat >&2")
  failed = 1
  exit 1
}

# The index of the instruction that a branch names: the first operand that is an address with its
# symbol, ADDRESS <SYMBOL+OFFSET>.
function target(i,    text) {
  text = operands[i]
  if (!match(text, /[0-9a-f]+ </)) {
    refuse(i, "a branch whose target is unknown")
  }
  text = substr(text, RSTART, RLENGTH - 2)
  if (!(text in index_at)) {
    refuse(i, "a branch out of the code")
  }
  return index_at[text]
}
