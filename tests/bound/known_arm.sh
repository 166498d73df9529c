#!/bin/sh
# Sourced by longest_path_test.sh: Thumb code without loops.
code arm '0|movs r0, #1
  2|bx lr'
longest "a straight line" "2 = fixed 2" none

code arm '0|cmp r0, #0
  2|beq.n 8 <f+0x8>
  4|movs r0, #1
  6|movs r1, #1
  8|bx lr'
longest "the longer of two branches" "5 = fixed 5" none

code arm '0|cbz r0, 6 <f+0x6>
  2|movs r0, #1
  4|bx lr
  6|b.n 4 <f+0x4>'
longest "a branch backwards that is no loop" "3 = fixed 3" none

code arm '0|it eq
  2|bxeq lr
  4|movs r0, #1
  6|pop {r4, pc}'
longest "a return that may be skipped" "4 = fixed 4" none

code arm '0|itt ne
  2|movne r0, #1
  4|ldmiane.w sp!, {r4, pc}
  6|ldmia.w sp!, {r4, r5, pc}'
longest "loads of the program counter return" "4 = fixed 4" none

code arm '0|bl 10 <g>
  4|bl 10 <g>
  8|bx lr
  00000010 <g>:
  10|nop
  12|bx lr'
longest "calls are counted" "7 = fixed 7" none

code arm '0|nop
  2|b.w 10 <g>
  00000010 <g>:
  10|nop
  12|bx lr'
longest "a call in tail position" "4 = fixed 4" none
printf 'apart ^g$\n' >table
longest "a call counted apart" "2 = fixed 2" table

code arm '0|nop
  2|b.n 2 <f+0x2>'
refused "a loop for ever" "a loop without a bound" none

code arm '0|blx r3
  2|bx lr'
refused "an indirect call" "not understood" none

code arm '0|tbb [pc, r0]
  4|.word 0x00000000'
refused "a table of branches" "not understood" none

code arm '0|mov pc, r0'
refused "a branch to a register" "not understood" none

code arm '0|bx r3'
refused "a return to what is not the link register" "not understood" none

code arm '0|movs r0, #1
  2|.word 0x00000000'
refused "data in the way" "not understood" none

code arm '0|nop'
refused "no end" "the function's end is reached" none

code arm '0|bl 0 <f>
  4|bx lr'
refused "recursion" "calls itself" none

code arm '0|bl 100 <elsewhere>
  4|bx lr'
refused "a call of what is not there" "out of the code" none

code arm '0|bicne r0, r1
  2|bfi r0, r1, #2, #3
  6|bics r0, r1
  8|bx lr'
longest "bits that are no branches" "4 = fixed 4" none

code arm '0|bfcsel 4, 8 <f+0x8>, 6, ne
  8|bx lr'
refused "a branch in the future" "not understood" none
