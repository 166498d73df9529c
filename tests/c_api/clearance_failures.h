/* How many checks of clearance.c failed. */
#ifndef FLASHBVH_TESTS_C_API_CLEARANCE_FAILURES_H
#define FLASHBVH_TESTS_C_API_CLEARANCE_FAILURES_H

long clearance_failures(void);

#endif
