# Arm MPS2 with the Cortex-M3 image AN385.
set(FLASHBVH_MACHINE mps2-an385)
set(FLASHBVH_CPU_FLAGS -mthumb -mcpu=cortex-m3)
set(FLASHBVH_SYSTICK_KHZ 25000)
