set(FLASHBVH_CORE Cortex-M33)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m33 -mfpu=fpv5-sp-d16 -mfloat-abi=hard)
