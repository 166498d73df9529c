# Arm MPS2 with the Cortex-M4F image AN386.
set(FLASHBVH_MACHINE mps2-an386)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard)
set(FLASHBVH_SYSTICK_KHZ 25000)
