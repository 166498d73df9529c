# Where an instruction of Thumb leads, on Armv6-M to Armv8.1-M. Sets
#   goes_on     1 if the next instruction may follow
#   jump        index of an instruction that may follow, 0 if none
#   call        index of a function that is entered and comes back, 0 if none
#   leaves      1 if the function may end here
# What isn't known to leave the program counter alone is refused.

# An instruction of an IT block may be skipped; objdump adds the condition to its mnemonic.
function in_it_block(i,    back) {
  for (back = 1; back <= 4 && i - back >= 1; ++back) {
    if (mnemonic[i - back] ~ /^it[te]*$/ && owner[i - back] == owner[i]) {
      return length(mnemonic[i - back]) - 1 >= back
    }
  }
  return 0
}

function is_bit_operation(name) {
  return name ~ /^(bics?|bf[ic])(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?$/
}

function flow_of(i,    name, first) {
  name = mnemonic[i]
  sub(/\.[nw]$/, "", name)
  goes_on = 1
  jump = call = leaves = 0
  first = operands[i]
  sub(/[,}].*$/, "", first)
  if (name ~ /^b(eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)$/ || name ~ /^cbn?z$/) {
    jump = target(i)
  } else if (name == "b") {
    jump = target(i)
    goes_on = in_it_block(i)
  } else if (name == "le" || name == "wls") {  # the low-overhead loops of Armv8.1-M
    jump = target(i)
  } else if (name == "dls") {
    return
  } else if (name == "bl") {
    call = target(i)
  } else if (name ~ /^bx(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?$/ && operands[i] == "lr") {
    leaves = 1
    goes_on = in_it_block(i)
  } else if (name ~ /^(pop|ldm(ia|fd)?)(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?$/) {
    leaves = operands[i] ~ /pc}/
    goes_on = !leaves || in_it_block(i)
  } else if (name ~ /^ldr(eq|ne)?$/ && operands[i] ~ /^pc, \[sp\], #/) {
    leaves = 1
    goes_on = in_it_block(i)
  } else if (name ~ /^(udf|bkpt|svc|hlt|tb[bh]|rfe.*|\..*|letp|wlstp.*|dlstp.*)$/ ||
      (name ~ /^b/ && !is_bit_operation(name)) || first == "pc" || name == "") {
    refuse(i, "not understood")
  }
}
