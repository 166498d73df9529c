# Arm MPS3 with the Cortex-M55 image AN547; code in tightly coupled memory, data in SRAM (secure).
set(FLASHBVH_CORE Cortex-M55)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m55 -mfloat-abi=hard)
set(FLASHBVH_MACHINE mps3-an547)
set(FLASHBVH_CLOCK_KHZ 32000)
set(FLASHBVH_FLASH 0x00000000)
set(FLASHBVH_FLASH_KB 512)
set(FLASHBVH_RAM 0x31000000)
set(FLASHBVH_RAM_KB 4096)
