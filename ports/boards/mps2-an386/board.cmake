# Arm MPS2 with the Cortex-M4F image AN386.
set(FLASHBVH_MACHINE mps2-an386)
set(FLASHBVH_CORE Cortex-M4F)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard)
set(FLASHBVH_SYSTICK_KHZ 25000)
set(FLASHBVH_FLASH_KB 4096)
set(FLASHBVH_BOARD_HAS_CATCH2 TRUE)
