set(FLASHBVH_CORE Cortex-M4F)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard)
