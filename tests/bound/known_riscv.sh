#!/bin/sh
# Sourced by longest_path_test.sh: RISC-V code without loops.
code riscv '0|beqz a0,6 <f+0x6>
  2|li a0,1
  4|addi a0,a0,1
  6|ret'
longest "the longer of two branches" "4 = fixed 4" none

code riscv '0|jal 10 <g>
  4|j 8 <f+0x8>
  8|ret
  00000010 <g>:
  10|lbu a0,0(a1)
  12|ret'
longest "a call" "5 = fixed 5" none

code riscv '0|jr a5'
refused "a branch to a register" "not understood" none

code riscv '0|jalr a5
  2|ret'
refused "an indirect call" "not understood" none

code riscv '0|ebreak
  2|ret'
refused "a trap" "not understood" none
