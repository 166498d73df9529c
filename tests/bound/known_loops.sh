#!/bin/sh
# Sourced by longest_path_test.sh: loops, and what the table says of them.
one_loop='0|movs r0, #3
  /source.c:4
  2|nop
  /source.c:2
  4|nop
  6|subs r0, #1
  8|bne.n 2 <f+0x2>
  a|bx lr'
code arm "$one_loop"
printf 'cut ^f$ turn 3 source.c for (i)\n' >table
longest "three turns" "14 = fixed 6 turn 2*4" table
printf 'cut ^f$ turn - source.c for (i)\n' >table
longest "turns without a number" "6 = fixed 6 turn 4" table
printf 'cut ^f$ turn 3 source.c visit\n' >table
longest "another line of the same loop" "14 = fixed 6 turn 2*4" table
printf 'cut ^f$ turn 3 - bne\n' >table
longest "a loop cut at a mnemonic" "14 = fixed 6 turn 2*4" table
refused "a loop without bound" "a loop without a bound" none
printf 'cut ^g$ turn 3 source.c for (i)\n' >table
refused "a bound of another function" "a loop without a bound" table
printf 'cut ^f$ turn 3 source.c while (i)\n' >table
refused "a line that is no more" "no 'while (i)' in source.c" table
printf 'cut ^f$ turn 3 source.c int f\n' >table
refused "a line outside the loop" "a loop without a bound" table

# The inner loop's turns are those of a whole call; its cut is in every turn of the outer one, too.
code arm '0|movs r0, #3
  /source.c:2
  2|movs r1, #3
  /source.c:3
  4|subs r1, #1
  6|bne.n 4 <f+0x4>
  /source.c:2
  8|subs r0, #1
  a|bne.n 2 <f+0x2>
  c|bx lr'
printf 'cut ^f$ outer 3 source.c for (i)\ncut ^f$ inner 9 source.c for (j)\n' >table
longest "a loop in a loop" "47 = fixed 7 inner 8*5" table

# The walk in small: irreducible, since it may start in the middle.
code arm '0|cbz r0, 8 <f+0x8>
  /source.c:4
  2|cbz r1, 10 <f+0x10>
  4|nop
  6|nop
  /source.c:1
  8|cmp r2, r3
  a|bne.n 2 <f+0x2>
  /source.c:5
  c|nop
  /source.c:1
  e|b.n 8 <f+0x8>
  10|bx lr'
printf 'cut ^f$ visit - source.c visit\ncut ^f$ ascent - source.c ascend\n' >table
longest "two kinds of turns in one loop" "11 = fixed 11 visit 5 ascent 6" table
printf 'cut ^f$ visit - source.c visit\n' >table
refused "one of two kinds of turns" "a loop without a bound" table

# Two statements of a line that the turns of one loop take in turn.
code arm '/source.c:1
  0|cbz r0, 6 <f+0x6>
  /source.c:2
  2|nop
  4|b.n 0 <f>
  /source.c:2
  6|nop
  8|cbz r1, c <f+0xc>
  /source.c:1
  a|b.n 0 <f>
  c|bx lr'
printf 'cut ^f$ turn 2 source.c for (i)\n' >table
refused "a loop that is cut twice" "cuts in two places" table
printf 'cut ^f$ turn - source.c for (i)\n' >table
longest "the same without a number" "4 = fixed 4 turn 4" table
