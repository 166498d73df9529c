# Toolchain file for every Arm board: -DFLASHBVH_BOARD=<folder of ports/boards>.
#
# No C++ library is linked, only its headers are used: hence -nostdlib and the libraries by name.

set(CMAKE_SYSTEM_PROCESSOR arm)
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
flashbvh_use_compiler(arm-none-eabi
  "gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-dev"
  "--specs=nano.specs -Wno-psabi")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -nostdlib")
set(CMAKE_C_STANDARD_LIBRARIES "-lm -lc_nano -lgcc")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lm -lc_nano -lgcc")
