# BBC micro:bit, a Cortex-M0. Catch2 does not fit.
set(FLASHBVH_MACHINE microbit)
set(FLASHBVH_CORE Cortex-M0)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m0)
set(FLASHBVH_SYSTICK_KHZ 16000)
set(FLASHBVH_FLASH_KB 256)
set(FLASHBVH_BOARD_HAS_CATCH2 FALSE)
