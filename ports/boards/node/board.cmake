# No board: WebAssembly, which node runs. Memories are as large as tests want them.
set(FLASHBVH_CORE WebAssembly)
set(FLASHBVH_CPU_FLAGS --target=wasm32-wasi)
set(FLASHBVH_MACHINE node)
set(FLASHBVH_FLASH_KB 16384)
set(FLASHBVH_RAM_KB 16384)
set(FLASHBVH_IS_MEASURED FALSE)  # it has no instructions to count, nor frames in memory
