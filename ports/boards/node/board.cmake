# WebAssembly in node, in place of a board. Memories are large enough for all tests.
set(FLASHBVH_CORE WebAssembly)
set(FLASHBVH_CPU_FLAGS --target=wasm32-wasi)
set(FLASHBVH_MACHINE node)
set(FLASHBVH_FLASH_KB 16384)
set(FLASHBVH_RAM_KB 16384)
set(FLASHBVH_IS_MEASURED FALSE)  # no instructions to count and no frames in memory
