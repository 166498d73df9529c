# The machine of ../virt with a core that has no compressed, atomic or float instructions.
include(${CMAKE_CURRENT_LIST_DIR}/../virt/board.cmake)
include(${FLASHBVH_CORES}/rv32im.cmake)
