/* The links' pre-indexed images, as `flashbvh bake` wrote them. */
  .section .rodata.images, "a"
  .macro image name
  .balign 4
  .global \name\()_pre, \name\()_pre_end
\name\()_pre:
  .incbin "pre/\name\().fbvh"
\name\()_pre_end:
  .endm

  image base_link
  image shoulder
  image bicep
  image elbow
  image forearm
  image wrist
  image palm
