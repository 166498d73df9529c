/* The arm as `flashbvh robot --format image` writes it. */
  .section .rodata.robot_image, "a"
  .balign 4
  .global robot_image, robot_image_end
robot_image:
  .incbin "i_arm.robot"
robot_image_end:
#if defined(__linux__)
  .section .note.GNU-stack, "", %progbits
#endif
