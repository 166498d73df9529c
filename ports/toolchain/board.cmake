# Common part of all boards' toolchain files. Reads ports/boards/<FLASHBVH_BOARD>/board.cmake.

set(CMAKE_SYSTEM_NAME Generic)
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

set(CMAKE_CROSSCOMPILING_EMULATOR ${flashbvh_ports}/run ${FLASHBVH_MACHINE})

# flashbvh_use_compiler(prefix packages flags): `flags` are added to the core's own.
macro(flashbvh_use_compiler prefix packages flags)
  find_program(FLASHBVH_CROSS_GXX ${prefix}-g++)
  if(NOT FLASHBVH_CROSS_GXX)
    message(FATAL_ERROR "${prefix}-g++ not found: apt-get install ${packages}")
  endif()
  set(CMAKE_C_COMPILER ${prefix}-gcc)
  set(CMAKE_CXX_COMPILER ${prefix}-g++)
  list(JOIN FLASHBVH_CPU_FLAGS " " cpu_flags)
  set(CMAKE_C_FLAGS_INIT "${cpu_flags} ${flags} -ffunction-sections -fdata-sections")
  set(CMAKE_CXX_FLAGS_INIT
    "${CMAKE_C_FLAGS_INIT} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
  set(CMAKE_EXE_LINKER_FLAGS_INIT
    "-nostartfiles -Wl,--gc-sections -Wl,--fatal-warnings -Wl,--no-warn-rwx-segments")
endmacro()
