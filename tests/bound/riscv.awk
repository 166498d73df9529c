# Where an instruction of RISC-V leads: see arm.awk for what is set.
function flow_of(i,    name) {
  name = mnemonic[i]
  sub(/^c\./, "", name)
  goes_on = 1
  jump = call = leaves = 0
  if (name ~ /^b(eq|ne|lt|ge|ltu|geu|gt|le|gtu|leu)z?$/) {
    jump = target(i)
  } else if (name == "j" || name == "tail") {
    jump = target(i)
    goes_on = 0
  } else if (name == "jal" || name == "call") {
    if (operands[i] ~ /^(t0|zero),/) {
      refuse(i, "not understood")
    }
    call = target(i)
  } else if (name == "ret") {
    leaves = 1
    goes_on = 0
  } else if (name ~ /^(j.*|b.*|e(call|break)|[msu]ret|wfi|unimp|\..*)$/ || name == "") {
    refuse(i, "not understood")
  }
}
