# Arm MPS2 with the Cortex-M33 image AN505; the secure memories, which the core starts in.
include(${FLASHBVH_CORES}/cortex-m33.cmake)
set(FLASHBVH_MACHINE mps2-an505)
set(FLASHBVH_CLOCK_KHZ 20000)
set(FLASHBVH_FLASH 0x10000000)
set(FLASHBVH_FLASH_KB 4096)
set(FLASHBVH_RAM 0x38000000)
set(FLASHBVH_RAM_KB 2048)
