# servo_guard_servos(name arm urdf [option of flashbvh_add_robot]...): the library `name`_servos, a guarded arm whose
# servos are in `arm`.hpp.
function(servo_guard_servos name arm urdf)
  set(folder ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  flashbvh_add_robot(${name}_arm URDF ${urdf} WARN 0.03 FORMAT both ${ARGN})
  file(CONFIGURE OUTPUT ${name}/arm.hpp @ONLY CONTENT
"#include \"@name@_arm.robot.h\"
#include \"steps.hpp\"
#define ARM(part) @name@_arm_##part
#include \"@arm@.hpp\"
")
  add_library(${name}_servos INTERFACE)
  target_include_directories(${name}_servos INTERFACE ${folder} ${CMAKE_CURRENT_BINARY_DIR}/${name})
  target_link_libraries(${name}_servos INTERFACE ${name}_arm)
endfunction()
