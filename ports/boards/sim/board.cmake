# QEMU's own Xtensa machine with the LX106, the core of an ESP8266: it boots from the system's ROM.
include(${FLASHBVH_CORES}/lx106.cmake)
set(FLASHBVH_MACHINE sim)
set(FLASHBVH_CLOCK_KHZ 40000)
set(FLASHBVH_FLASH 0x50000000)
set(FLASHBVH_FLASH_KB 16384)
set(FLASHBVH_RAM 0x60000000)
set(FLASHBVH_RAM_KB 16384)
