# Toolchain file for every RISC-V board: -DFLASHBVH_BOARD=<folder of ports/boards>.
#
# The C library is picolibc. Debian has no C++ library for this compiler, not even headers. The driver
# would link libstdc++ nevertheless, hence -nostdlib and the libraries by name.

set(CMAKE_SYSTEM_PROCESSOR riscv)
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
flashbvh_use_compiler(riscv64-unknown-elf
  "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf" "--specs=picolibc.specs")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -nostdlib")
set(CMAKE_C_STANDARD_LIBRARIES "-lc -lgcc")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lc -lgcc")
