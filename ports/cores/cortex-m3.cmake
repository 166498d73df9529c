set(FLASHBVH_CORE Cortex-M3)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m3)
