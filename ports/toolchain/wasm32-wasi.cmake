# Toolchain file for WebAssembly: Clang, wasi-libc and its C++ library.

set(CMAKE_SYSTEM_PROCESSOR wasm)
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
if(NOT EXISTS /usr/lib/wasm32-wasi/libc++.a OR NOT EXISTS /usr/bin/llvm-ar)
  message(FATAL_ERROR "no C++ library for WebAssembly: apt-get install clang lld llvm wasi-libc "
    "libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32")
endif()
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR /usr/bin/llvm-ar)
set(CMAKE_RANLIB /usr/bin/llvm-ranlib)
set(CMAKE_C_FLAGS_INIT "-ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT} -fno-exceptions -fno-rtti")
# The stack lies below all other data, so that an overflow traps.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,--gc-sections -Wl,--fatal-warnings -Wl,--stack-first -Wl,-z,stack-size=65536")
