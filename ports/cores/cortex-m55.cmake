set(FLASHBVH_CORE Cortex-M55)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m55 -mfloat-abi=hard)
