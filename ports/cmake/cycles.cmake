# The target flashbvh_cycles, built by this machine's compiler: QEMU's plugin that counts cycles (lib/docs/cycles.md),
# and a program that prints the most cycles of instructions. FLASHBVH_CYCLES: QEMU's options that run the plugin with
# the table of this core. Unless the table is rough, FLASHBVH_CYCLES_CORES: the cores whose cycles are proven from
# machine code; and FLASHBVH_MOST_CYCLES: the command that prints them.
set(FLASHBVH_CYCLES "" CACHE INTERNAL "")
set(FLASHBVH_CYCLES_CORES "" CACHE INTERNAL "")
set(FLASHBVH_MOST_CYCLES "" CACHE INTERNAL "")
string(TOLOWER "${FLASHBVH_CORE}" table)
set(cycles_folder ${CMAKE_CURRENT_LIST_DIR}/../cycles)
if(NOT EXISTS ${cycles_folder}/tables/${table}.csv)
  return()
endif()

find_program(FLASHBVH_HOST_CXX NAMES c++ g++ clang++ REQUIRED)
file(GLOB headers CONFIGURE_DEPENDS ${cycles_folder}/*.hpp ${cycles_folder}/*.h)
foreach(source flash most pipeline plugin table thumb)
  set(object ${CMAKE_CURRENT_BINARY_DIR}/cycles/${source}.o)
  add_custom_command(OUTPUT ${object}
    COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${FLASHBVH_HOST_CXX} -std=c++17 -O2 -fPIC
      -c ${cycles_folder}/${source}.cpp -o ${object}
    DEPENDS ${cycles_folder}/${source}.cpp ${headers}
    VERBATIM)
endforeach()
# link_host_code(output source... [option...])
function(link_host_code output)
  list(TRANSFORM ARGN REPLACE "^[a-z]+$" "${CMAKE_CURRENT_BINARY_DIR}/cycles/\\0.o" OUTPUT_VARIABLE objects)
  set(inputs ${objects})
  list(FILTER inputs INCLUDE REGEX "[.]o$")
  add_custom_command(OUTPUT ${output} COMMAND ${FLASHBVH_HOST_CXX} ${objects} -o ${output}
    DEPENDS ${inputs} VERBATIM)
endfunction()
set(plugin ${CMAKE_BINARY_DIR}/bin/flashbvh_cycles.so)
link_host_code(${plugin} flash pipeline plugin table thumb -shared)
set(most ${CMAKE_BINARY_DIR}/bin/flashbvh_most_cycles)
link_host_code(${most} most pipeline table thumb)
add_custom_target(flashbvh_cycles DEPENDS ${plugin} ${most})

string(JOIN "," FLASHBVH_CYCLES "-plugin ${plugin}" tables=${cycles_folder}/tables core=${table}
  flash_begin=${FLASHBVH_FLASH} flash_kb=${FLASHBVH_FLASH_KB} result=flashbvh.cycles)
set(FLASHBVH_CYCLES "${FLASHBVH_CYCLES}" CACHE INTERNAL "")
file(STRINGS ${cycles_folder}/tables/${table}.csv rough REGEX ",rough:")
if(NOT rough)
  set(cores ${FLASHBVH_CORE})
  if(FLASHBVH_CORE STREQUAL "Cortex-M0")
    set(cores Cortex-M0 Cortex-M0-Fast Cortex-M0+ Cortex-M0+-Fast)
  endif()
  set(FLASHBVH_CYCLES_CORES ${cores} CACHE INTERNAL "")
  set(FLASHBVH_MOST_CYCLES ${most} ${cycles_folder}/tables CACHE INTERNAL "")
endif()
