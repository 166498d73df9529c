/* The sample program, in flash. */
  .section .rodata.program, "a"
  .global program_begin, program_end
program_begin:
  .incbin "program.txt"
program_end:
