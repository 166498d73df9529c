# QEMU's own Xtensa machine with the LX106, the core of an ESP8266: it boots from the system's ROM.
set(FLASHBVH_CORE LX106)
set(FLASHBVH_CPU_FLAGS "")
# Has no budgets and no proofs; its figures are not on the page.
set(FLASHBVH_IS_MEASURED FALSE)
set(FLASHBVH_MACHINE sim)
set(FLASHBVH_CLOCK_KHZ 40000)
set(FLASHBVH_FLASH 0x50000000)
set(FLASHBVH_FLASH_KB 16384)
set(FLASHBVH_RAM 0x60000000)
set(FLASHBVH_RAM_KB 16384)
