# flashbvh_add_robot(name URDF file
#                    [PACKAGE name=folder]... [SRDF file] [BELIEVE link,link]... [CELL length] [LEAF_SIZE n] [STOP length]
#                    [WARN length] [PAIR link,link=stop[,warn]]... [FORMAT cpp|c|image])
#
# A library `name`, also called name::name, with the baked robot name::robot. A target that links it
# includes "<name>.robot.hpp", and has flashbvh::robot. With FORMAT c it is name_robot, and the header
# "<name>.robot.h". FORMAT image makes no code: the folder of <name>.robot, for open_robot(), is an include
# folder of each target that links the library, for .incbin. The options are those of `flashbvh robot`;
# lengths are in metres. The robot is baked again when the URDF, the SRDF, one of the meshes, an option
# or the tool changes; which meshes, the tool says in a depfile.
include(${CMAKE_CURRENT_LIST_DIR}/host_tool.cmake)

function(flashbvh_add_robot name)
  # Depfiles as Ninja wants them, even if the caller requires an older CMake.
  cmake_policy(SET CMP0116 NEW)
  set(files URDF SRDF)
  set(single CELL LEAF_SIZE STOP WARN FORMAT)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "${files};${single}" "PACKAGE;PAIR;BELIEVE")
  set(odd ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES} ${arg_PACKAGE} ${arg_PAIR})
  list(FILTER odd EXCLUDE REGEX "^[^=]+=.+$")
  if(odd OR arg_UNPARSED_ARGUMENTS OR NOT arg_URDF)
    message(FATAL_ERROR "flashbvh_add_robot(${name}): give URDF file and options with their values, "
      "PACKAGE as name=folder, PAIR as link,link=length; not understood: ${odd}")
  endif()
  if(NOT name MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "flashbvh_add_robot(${name}): the name is that of a C++ namespace; use letters, "
      "digits and '_'")
  endif()
  set(depends "")
  foreach(file ${files})
    if(arg_${file})
      get_filename_component(arg_${file} ${arg_${file}} ABSOLUTE)
      list(APPEND depends ${arg_${file}})
    endif()
  endforeach()
  set(options "")
  foreach(option SRDF ${single})
    if(DEFINED arg_${option})
      string(TOLOWER --${option} flag)
      string(REPLACE "_" "-" flag ${flag})
      list(APPEND options ${flag} ${arg_${option}})
    endif()
  endforeach()
  foreach(package IN LISTS arg_PACKAGE)
    string(REGEX MATCH "^[^=]+=" package_name "${package}")
    string(REGEX REPLACE "^[^=]+=" "" package_folder "${package}")
    get_filename_component(package_folder "${package_folder}" ABSOLUTE)
    list(APPEND options --package "${package_name}${package_folder}")
  endforeach()
  foreach(pair IN LISTS arg_PAIR)
    list(APPEND options --pair "${pair}")
  endforeach()
  foreach(pair IN LISTS arg_BELIEVE)
    list(APPEND options --believe "${pair}")
  endforeach()
  if(NOT arg_FORMAT OR arg_FORMAT STREQUAL "cpp")
    set(extensions .hpp .cpp)
  elseif(arg_FORMAT STREQUAL "c")
    set(extensions .h .c)
  elseif(arg_FORMAT STREQUAL "image")
    set(extensions "")
  else()
    message(FATAL_ERROR "flashbvh_add_robot(${name}): FORMAT is cpp, c or image, not ${arg_FORMAT}")
  endif()
  flashbvh_robot_command(${name} ${arg_URDF} "${options}" "${depends}" "${extensions}")
endfunction()

# The custom command and the library that holds what it makes.
function(flashbvh_robot_command name urdf options files extensions)
  cmake_policy(SET CMP0116 NEW)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/flashbvh/${name})
  set(stem ${folder}/${name}.robot)
  # A file that changes with the options: not every generator minds how a command is called.
  file(CONFIGURE OUTPUT ${folder}/options.txt CONTENT "${urdf};${options}" @ONLY)
  flashbvh_host_tool(program depends)
  set(made ${stem})
  if(extensions)
    list(TRANSFORM extensions PREPEND ${stem} OUTPUT_VARIABLE made)
  endif()
  add_custom_command(OUTPUT ${made}
    COMMAND ${program} robot ${urdf} -o ${folder} --name ${name} --depfile ${stem}.d ${options}
    DEPENDS ${files} ${folder}/options.txt ${depends}
    DEPFILE ${stem}.d
    COMMENT "Baking ${name}"
    VERBATIM)
  set(kind PUBLIC)
  if(extensions)
    add_library(${name} STATIC ${made})
  else()
    set(kind INTERFACE)
    add_library(${name} INTERFACE ${made})
  endif()
  add_library(${name}::${name} ALIAS ${name})
  target_include_directories(${name} ${kind} ${folder})
  target_link_libraries(${name} ${kind} flashbvh::robot)
endfunction()
