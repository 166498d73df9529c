# Arm MPS2 with the Cortex-M33 image AN505; code in SSRAM, data in PSRAM.
set(FLASHBVH_CORE Cortex-M33)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m33 -mfpu=fpv5-sp-d16 -mfloat-abi=hard)
set(FLASHBVH_MACHINE mps2-an505)
set(FLASHBVH_CLOCK_KHZ 20000)
set(FLASHBVH_FLASH 0x10000000)
set(FLASHBVH_FLASH_KB 4096)
set(FLASHBVH_RAM 0x80000000)
set(FLASHBVH_RAM_KB 16384)
