# QEMU's own RISC-V machine: one memory, whose lower part is used as flash.
set(FLASHBVH_CORE RV32IMAC)
set(FLASHBVH_CPU_FLAGS -march=rv32imac -mabi=ilp32)
set(FLASHBVH_MACHINE virt)
set(FLASHBVH_FLASH 0x80000000)
set(FLASHBVH_FLASH_KB 16384)
set(FLASHBVH_RAM 0x81000000)
set(FLASHBVH_RAM_KB 16384)
