# The plugin of QEMU that counts cycles (lib/docs/cycles.md): the target flashbvh_cycles, built by this
# machine's compiler, and FLASHBVH_CYCLES, QEMU's options that run it by the table of this core.
set(FLASHBVH_CYCLES "" CACHE INTERNAL "")
string(TOLOWER "${FLASHBVH_CORE}" table)
set(cycles_folder ${CMAKE_CURRENT_LIST_DIR}/../cycles)
if(NOT EXISTS ${cycles_folder}/tables/${table}.csv)
  return()
endif()

find_program(FLASHBVH_HOST_CXX NAMES c++ g++ clang++ REQUIRED)
file(GLOB headers CONFIGURE_DEPENDS ${cycles_folder}/*.hpp ${cycles_folder}/*.h)
set(objects "")
foreach(source flash pipeline plugin table thumb)
  set(object ${CMAKE_CURRENT_BINARY_DIR}/cycles/${source}.o)
  add_custom_command(OUTPUT ${object}
    COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${FLASHBVH_HOST_CXX} -std=c++17 -O2 -fPIC
      -c ${cycles_folder}/${source}.cpp -o ${object}
    DEPENDS ${cycles_folder}/${source}.cpp ${headers}
    VERBATIM)
  list(APPEND objects ${object})
endforeach()
set(plugin ${CMAKE_BINARY_DIR}/bin/flashbvh_cycles.so)
add_custom_command(OUTPUT ${plugin}
  COMMAND ${FLASHBVH_HOST_CXX} -shared ${objects} -o ${plugin}
  DEPENDS ${objects}
  VERBATIM)
add_custom_target(flashbvh_cycles DEPENDS ${plugin})

string(JOIN "," FLASHBVH_CYCLES "-plugin ${plugin}" tables=${cycles_folder}/tables core=${table}
  flash_begin=${FLASHBVH_FLASH} flash_kb=${FLASHBVH_FLASH_KB} result=flashbvh.cycles)
set(FLASHBVH_CYCLES "${FLASHBVH_CYCLES}" CACHE INTERNAL "")
