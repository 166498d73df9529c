# Toolchain file for every board with an Xtensa LX106.
#
# The C library is picolibc. As for RISC-V, there is no C++ library. libgcc omits arithmetic that real
# parts have in ROM; xtensa/arithmetic.cpp and xtensa/float.cpp provide it.

set(CMAKE_SYSTEM_PROCESSOR xtensa)
set(FLASHBVH_HAS_CXX_LIBRARY FALSE)
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
flashbvh_use_compiler(xtensa-lx106-elf "gcc-xtensa-lx106 picolibc-xtensa-lx106-elf"
  "--specs=/usr/lib/xtensa-lx106-elf/picolibc.specs -mlongcalls -mtext-section-literals")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -nostdlib")
set(CMAKE_C_STANDARD_LIBRARIES "-lc -lgcc")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lc -lgcc")
