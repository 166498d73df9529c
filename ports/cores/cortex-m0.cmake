set(FLASHBVH_CORE Cortex-M0)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m0)
