# Toolchain file for every Arm board: -DFLASHBVH_BOARD=<folder of ports/boards>.

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FLASHBVH_BOARD)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH flashbvh_ports)
set(board_file ${flashbvh_ports}/boards/${FLASHBVH_BOARD}/board.cmake)
if(NOT FLASHBVH_BOARD OR NOT EXISTS ${board_file})
  file(GLOB known RELATIVE ${flashbvh_ports}/boards ${flashbvh_ports}/boards/*)
  list(JOIN known ", " known)
  message(FATAL_ERROR "FLASHBVH_BOARD is '${FLASHBVH_BOARD}'; give one of: ${known}")
endif()
include(${board_file})

find_program(FLASHBVH_ARM_GXX arm-none-eabi-g++)
if(NOT FLASHBVH_ARM_GXX)
  message(FATAL_ERROR "arm-none-eabi-g++ not found: apt-get install "
    "gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib")
endif()
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)

list(JOIN FLASHBVH_CPU_FLAGS " " cpu_flags)
set(common_flags "${cpu_flags} --specs=nano.specs -ffunction-sections -fdata-sections -Wno-psabi")
set(CMAKE_C_FLAGS_INIT "${common_flags}")
set(CMAKE_CXX_FLAGS_INIT
  "${common_flags} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
set(CMAKE_EXE_LINKER_FLAGS_INIT
  "-nostartfiles -Wl,--gc-sections -Wl,--fatal-warnings -Wl,--no-warn-rwx-segments")

set(CMAKE_CROSSCOMPILING_EMULATOR ${flashbvh_ports}/run ${FLASHBVH_MACHINE})
