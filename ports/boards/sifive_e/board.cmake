# SiFive's HiFive1: an FE310, an E31 core that runs from serial flash.
include(${CMAKE_CURRENT_LIST_DIR}/../virt/board.cmake)
set(FLASHBVH_MACHINE sifive_e)
set(FLASHBVH_FLASH 0x20400000)
set(FLASHBVH_FLASH_KB 12288)
set(FLASHBVH_RAM 0x80000000)
set(FLASHBVH_RAM_KB 16)
