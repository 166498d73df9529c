set(FLASHBVH_CORE RV32IMAC)
set(FLASHBVH_CPU_FLAGS -march=rv32imac -mabi=ilp32)
