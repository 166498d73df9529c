find_package(Python3 COMPONENTS Interpreter REQUIRED)

# servo_guard_servos(name arm urdf [option of flashbvh_add_robot]...): the library `name`_servos, a guarded arm. `arm`.txt
# lists its servos.
function(servo_guard_servos name arm urdf)
  set(folder ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  flashbvh_add_robot(${name}_arm URDF ${urdf} WARN 0.03 FORMAT both ${ARGN})
  set(header ${CMAKE_CURRENT_BINARY_DIR}/${name}/arm.hpp)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name})
  add_custom_command(OUTPUT ${header} DEPENDS ${folder}/arm.py ${folder}/${arm}.txt VERBATIM
    COMMAND Python3::Interpreter ${folder}/arm.py ${name}_arm ${folder}/${arm}.txt ${header})
  add_library(${name}_servos INTERFACE ${header})
  target_include_directories(${name}_servos INTERFACE ${folder} ${CMAKE_CURRENT_BINARY_DIR}/${name})
  target_link_libraries(${name}_servos INTERFACE ${name}_arm)
endfunction()
