/* The sizes of the structs that flashbvh/_c.py declares again, in its order. */
#include "flashbvh/robot.h"

extern const uint32_t flashbvh_python_layout[];
const uint32_t flashbvh_python_layout[] = {sizeof(flashbvh_mesh),
                                           sizeof(flashbvh_pose),
                                           sizeof(flashbvh_query),
                                           sizeof(flashbvh_pair),
                                           sizeof(flashbvh_witness),
                                           sizeof(flashbvh_run_result),
                                           sizeof(flashbvh_clearance),
                                           sizeof(flashbvh_point),
                                           sizeof(flashbvh_robot),
                                           sizeof(flashbvh_guard),
                                           sizeof(flashbvh_guard_answer),
                                           sizeof(flashbvh_limit_answer),
                                           FLASHBVH_GUARD_STATE_SIZE(5, 7, 11)};
