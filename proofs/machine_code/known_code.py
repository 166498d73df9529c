"""Code with known longest paths and frames: a function f, and optionally a function g that it calls.

";" or a new line ends an instruction; "/N" assigns the following code to line N of SOURCE.
"""
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Case:
    name: str
    what: str  # "path", "frame" (its size, and the size at each call)
    # or "refused"
    code: str
    wanted: str
    table: str = ""


SOURCE = "int f(void)\nfor (i)\n  for (j)\nvisit\nascend\n"
LEAF = "; g: nop; bx lr"

ARM = [
    Case("a straight line", "path", "movs r0, #1; bx lr", "2 = fixed 2"),
    Case("the longer of two branches", "path",
         "cmp r0, #0; beq 1f; movs r0, #1; movs r1, #1; 1: bx lr", "5 = fixed 5"),
    Case("a branch backwards that is no loop", "path",
         "cbz r0, 2f; 1: movs r0, #1; bx lr; 2: b 1b", "4 = fixed 4"),
    Case("a return that may be skipped", "path",
         "it eq; bxeq lr; movs r0, #1; pop {r4, pc}", "4 = fixed 4"),
    Case("loads of the program counter return", "path",
         "itt ne; movne r0, #1; ldmiane.w sp!, {r4, pc}; ldmia.w sp!, {r4, r5, pc}", "4 = fixed 4"),
    Case("calls are counted", "path", "bl g; bl g; bx lr" + LEAF, "7 = fixed 7"),
    Case("a call in tail position", "path", "nop; b.w g" + LEAF, "4 = fixed 4"),
    Case("a call counted apart", "path", "nop; b.w g" + LEAF, "2 = fixed 2", "apart ^g$"),
    Case("data after the end", "path", "ldr r0, 1f; bx lr; .balign 4; 1: .word 0xBF00BF00",
         "2 = fixed 2"),
    Case("bits that are no branches", "path",
         "it ne; bicne r0, r1; bfi r0, r1, #2, #3; bics r0, r1; bx lr", "5 = fixed 5"),
    Case("arithmetic of Armv8.1-M", "path", "cinc r0, r1, ne; csel r2, r0, r1, eq; bx lr",
         "3 = fixed 3"),
    Case("a loop for ever", "refused", "nop; 1: b 1b", "a loop without a bound"),
    Case("a loop of Armv8.1-M", "refused", "dls lr, r0; 1: nop; le lr, 1b; bx lr",
         "a loop without a bound"),
    Case("a loop of Armv8.1-M that does not turn", "path",
         "wls lr, r0, 1f; bx lr; 1: nop; nop; bx lr", "4 = fixed 4"),
    Case("an indirect call", "refused", "blx r3; bx lr", "not understood"),
    Case("a table of branches", "refused", "tbb [pc, r0]; .byte 1, 1; bx lr", "not understood"),
    Case("a branch to a register", "refused", "mov pc, r0", "not understood"),
    Case("a return to what is not the link register", "refused", "bx r3", "not understood"),
    Case("a load of the program counter", "refused", "ldr pc, [r0]", "not understood"),
    Case("a trap", "refused", "udf #0", "not understood"),
    Case("data behind the size of a function", "path", "nop; bx lr; .size f, .-f; movs r0, #1", "2 = fixed 2"),
    Case("code behind the size of a function", "refused", "b 1f; .size f, .-f; 1: bx lr", "out of the code"),
    Case("data in the way", "refused", "movs r0, #1; .word 0", "no code of the function"),
    Case("no end", "refused", "nop; .balign 4; g: bx lr", "the function's end is reached"),
    Case("code that nothing leads to", "refused", "bx lr; movs r0, #1", "nothing leads here"),
    Case("recursion", "refused", "bl f; bx lr", "calls itself"),
    Case("a branch in the future", "refused", "1: .inst.w 0xf0c0e001; bx lr", "not understood"),
    Case("a frame", "frame", "push {r4, lr}; sub sp, #24; bl g; add sp, #24; pop {r4, pc}" + LEAF,
         "32 32"),
    Case("large frames", "frame", "sub.w sp, sp, #0x2000; subw sp, sp, #260; bl g; "
         "addw sp, sp, #260; add.w sp, sp, #0x2000; bx lr" + LEAF, "8452 8452"),
    Case("a frame that is gone at a call", "frame",
         "stmdb sp!, {r4-r8, lr}; ldmia.w sp!, {r4-r8, lr}; b.w g" + LEAF, "24 0"),
    Case("a frame of one register", "frame",
         "str lr, [sp, #-4]!; bl g; ldr pc, [sp], #4" + LEAF, "4 4"),
    Case("a frame of two registers", "frame",
         "strd r4, r5, [sp, #-16]!; bl g; ldrd r4, r5, [sp], #16; bx lr" + LEAF, "16 16"),
    Case("a frame of floating point", "frame",
         ".fpu fpv5-d16; vpush {d8-d10}; vpop {d8-d10}; bx lr", "24"),
    Case("the deeper of two ways", "frame", "push {r4}; cbz r0, 1f; push {r5}; bl g; pop {r5}; 1: "
         "pop {r4}; b.w g" + LEAF, "8 8 0"),
    Case("who does not return keeps the frame", "frame",
         "push {r4, lr}; it eq; popeq {r4, pc}; bl g; pop {r4, pc}" + LEAF, "8 8"),
    Case("the cases of a table of branches", "frame",
         "push {r4, lr}; tbb [pc, r0]; .byte 1, 3; bl g; pop {r4, pc}; push {r5}; pop {r5}; "
         "pop {r4, pc}" + LEAF, "12 8"),
    Case("a frame of no fixed size", "refused frame", "sub sp, sp, r0; bx lr", "no fixed size"),
    Case("a frame that a register knows", "refused frame", "mov sp, r7; bx lr", "no fixed size"),
    Case("a push that may be skipped", "refused frame", "it ne; pushne {r4}; bx lr",
         "no fixed size"),
    Case("a loop that pushes", "refused frame", "1: push {r4}; b 1b", "has no end"),
]

RISCV = [
    Case("the longer of two branches", "path", "beqz a0, 1f; li a0, 1; 1: addi a0, a0, 1; ret",
         "4 = fixed 4"),
    Case("a call", "path", "jal g; j 1f; 1: ret; g: lbu a0, 0(a1); ret", "5 = fixed 5"),
    Case("a branch to a register", "refused", "jr a5", "not understood"),
    Case("an indirect call", "refused", "jalr a5; ret", "not understood"),
    Case("a trap", "refused", "ebreak; ret", "not understood"),
    Case("a loop", "refused", "1: addi a0, a0, -1; bnez a0, 1b; ret", "a loop without a bound"),
    Case("a frame", "frame", "addi sp, sp, -144; jal g; addi sp, sp, 144; ret; g: ret",
         "144 144"),
    Case("a small frame", "frame", "addi sp, sp, -16; addi sp, sp, 16; j g; g: nop; ret", "16 0"),
    Case("a large frame", "frame", "addi sp, sp, -2032; addi sp, sp, -16; jal g; "
         "addi sp, sp, 1024; addi sp, sp, 1024; ret; g: ret", "2048 2048"),
    Case("a frame of no fixed size", "refused frame", "sub sp, sp, a0; ret", "no fixed size"),
    Case("a frame that a register knows", "refused frame", "mv sp, s0; ret", "no fixed size"),
]

CASES = {"arm": ARM, "riscv": RISCV}

TURNS = "movs r0, #3; /4; 1: nop; /2; nop; subs r0, #1; bne 1b; bx lr"
# The inner loop's count is that of a whole call; its cut lies in every turn of the outer loop, too.
NESTED = ("movs r0, #3; /2; 1: movs r1, #3; /3; 2: subs r1, #1; bne 2b; /2; subs r0, #1; bne 1b; "
          "bx lr")
# A small walk: irreducible, since it may start in the middle.
WALK = ("cbz r0, 2f; /4; 1: cbz r1, 3f; nop; nop; /1; 2: cmp r2, r3; bne 1b; /5; nop; /1; b 2b; "
        "3: bx lr")
# Two statements of a line, executed alternately in the turns of a loop.
TWICE = "1: cbz r0, 2f; /2; nop; b 1b; /2; 2: nop; cbz r1, 3f; /1; b 1b; 3: bx lr"

LOOP_CASES = [
    Case("three turns", "path", TURNS, "14 = fixed 6 turn 2*4", "cut ^f$ turn 3 source.c for (i)"),
    Case("turns without a number", "path", TURNS, "6 = fixed 6 turn 4",
         "cut ^f$ turn - source.c for (i)"),
    Case("another line of the same loop", "path", TURNS, "14 = fixed 6 turn 2*4",
         "cut ^f$ turn 3 source.c visit"),
    Case("a loop cut at a condition", "path", TURNS, "14 = fixed 6 turn 2*4",
         "cut ^f$ turn 3 - bne"),
    Case("a loop without bound", "refused", TURNS, "a loop without a bound"),
    Case("a bound of another function", "refused", TURNS, "a loop without a bound",
         "cut ^g$ turn 3 source.c for (i)"),
    Case("a line that is no more", "refused", TURNS, "no 'while (i)' in source.c",
         "cut ^f$ turn 3 source.c while (i)"),
    Case("a line outside the loop", "refused", TURNS, "a loop without a bound",
         "cut ^f$ turn 3 source.c (void)"),
    Case("a table of an unknown form", "refused", TURNS, "not understood", "cat ^f$ turn 3"),
    Case("a loop in a loop", "path", NESTED, "47 = fixed 7 inner 8*5",
         "cut ^f$ outer 3 source.c for (i)\ncut ^f$ inner 9 source.c for (j)"),
    Case("two kinds of turns in one loop", "path", WALK, "11 = fixed 11 visit 5 ascent 6",
         "cut ^f$ visit - source.c visit\ncut ^f$ ascent - source.c ascend"),
    Case("one of two kinds of turns", "refused", WALK, "a loop without a bound",
         "cut ^f$ visit - source.c visit"),
    Case("a loop that is cut twice", "refused", TWICE, "cuts in two places",
         "cut ^f$ turn 2 source.c for (i)"),
    Case("the same without a number", "path", TWICE, "4 = fixed 4 turn 4",
         "cut ^f$ turn - source.c for (i)"),
    Case("turns that a call leaves open", "refused", "bl g; bx lr; g:; /2; 1: nop; bne 1b; bx lr",
         "has no bound of its own", "cut ^g$ turn - source.c for (i)"),
]
