# flashbvh_write_shape(output shape size...): writes the output of meshes.py to `output`, in each build.
include_guard()
find_program(python python3 REQUIRED)
set(FLASHBVH_SHAPES ${CMAKE_CURRENT_LIST_DIR}/meshes.py)
set(FLASHBVH_MACHINES ${CMAKE_CURRENT_LIST_DIR}/machines.py)
function(flashbvh_write_shape output)
  add_custom_command(OUTPUT ${output}
    COMMAND ${python} -B ${FLASHBVH_SHAPES} ${ARGN} > ${output}
    DEPENDS ${FLASHBVH_SHAPES} ${FLASHBVH_MACHINES}
    VERBATIM)
endfunction()
