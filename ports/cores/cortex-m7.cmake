set(FLASHBVH_CORE Cortex-M7)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard)
