# flashbvh_write_shape(output shape size...): writes the output of meshes.py to `output`, in each build.
include_guard()
find_program(python python3 REQUIRED)
set(FLASHBVH_SHAPES ${CMAKE_CURRENT_LIST_DIR}/meshes.py)
function(flashbvh_write_shape output)
  add_custom_command(OUTPUT ${output}
    COMMAND ${python} ${FLASHBVH_SHAPES} ${ARGN} > ${output}
    DEPENDS ${FLASHBVH_SHAPES}
    VERBATIM)
endfunction()

# flashbvh_write_machine(variable body...): writes <body>.obj by machines.py to the build folder; lists the files.
set(FLASHBVH_MACHINES ${CMAKE_CURRENT_LIST_DIR}/machines.py)
function(flashbvh_write_machine variable)
  set(written "")
  foreach(body IN LISTS ARGN)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${body}.obj)
    add_custom_command(OUTPUT ${output}
      COMMAND ${python} -B ${FLASHBVH_MACHINES} ${body} > ${output}
      DEPENDS ${FLASHBVH_MACHINES} ${FLASHBVH_SHAPES}
      VERBATIM)
    list(APPEND written ${output})
  endforeach()
  set(${variable} ${written} PARENT_SCOPE)
endfunction()
