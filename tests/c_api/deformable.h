/* A mesh that bends, in C. */
#ifndef FLASHBVH_TESTS_C_API_DEFORMABLE_H
#define FLASHBVH_TESTS_C_API_DEFORMABLE_H

/** How many checks of deformable.c failed. */
long deformable_failures(void);

#endif
