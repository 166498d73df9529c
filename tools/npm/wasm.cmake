# Toolchain file: WebAssembly for node, by Emscripten. The program reads and writes the machine's own files. It
# compiles synchronously: Emscripten's other method takes a node that has fetch() for a browser.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions")
set(options ENVIRONMENT=node NODERAWFS WASM_ASYNC_COMPILATION=0 EXIT_RUNTIME ALLOW_MEMORY_GROWTH MAXIMUM_MEMORY=4GB
  NODEJS_CATCH_EXIT=0 NODEJS_CATCH_REJECTION=0)
list(TRANSFORM options PREPEND "-s")
list(JOIN options " " options)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions ${options} --pre-js ${CMAKE_CURRENT_LIST_DIR}/before.js")
