# The machine of ../virt with a core that has no compressed, atomic or float instructions.
include(${CMAKE_CURRENT_LIST_DIR}/../virt/board.cmake)
set(FLASHBVH_CORE RV32IM)
set(FLASHBVH_CPU_FLAGS -march=rv32im -mabi=ilp32)
# GCC emits the instructions for RV32IMAC in longer encodings, so time bound, stack and counts must equal that core's.
set(FLASHBVH_IS_MEASURED FALSE)
set(FLASHBVH_PROVEN_AS RV32IMAC)
