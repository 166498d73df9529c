# Toolchain file for every Arm board: -DFLASHBVH_BOARD=<folder of ports/boards>.

set(CMAKE_SYSTEM_PROCESSOR arm)
set(FLASHBVH_HAS_CXX_LIBRARY TRUE)
include(${CMAKE_CURRENT_LIST_DIR}/board.cmake)
flashbvh_use_compiler(arm-none-eabi
  "gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib"
  "--specs=nano.specs -Wno-psabi")
