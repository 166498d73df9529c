# flashbvh_add_robot(name URDF file [VISUAL_TOO]
#                    [PACKAGE name=folder]... [SRDF file] [JOINT_LIMITS file] [BELIEVE link,link]... [CELL length] [LEAF_SIZE n]
#                    [SIMPLIFY length] [FIT bytes] [STOP length]
#                    [WARN length] [PAIR link,link=stop[,warn]]... [ZONE joint=length]... [TIME seconds] [FORMAT c|image|both])
#
# Adds a library `name`, also called name::name, with the image of a robot. A target that links it
# includes "<name>.robot.h", for C and C++, which declares the array <name>_robot_image for
# view_robot_unchecked(), and has flashbvh::robot. FORMAT image makes no code: each target that links the
# library gets the folder of <name>.robot, an image for open_robot(), as an include folder, for .incbin.
# FORMAT both makes both. The file may be MJCF or SDF, too. The options are those of `flashbvh robot`; lengths
# are in metres. The build bakes the robot again if its file, the SRDF, the joint limits, a mesh, an included
# file, an option or the tool changes; the tool lists the files in a depfile.
include(${CMAKE_CURRENT_LIST_DIR}/host_tool.cmake)

function(flashbvh_add_robot name)
  # Ninja needs this form of depfile, even if the caller requires an older CMake.
  cmake_policy(SET CMP0116 NEW)
  set(files URDF SRDF JOINT_LIMITS)
  set(single CELL LEAF_SIZE SIMPLIFY FIT STOP WARN TIME FORMAT)
  cmake_parse_arguments(PARSE_ARGV 1 arg "VISUAL_TOO" "${files};${single}" "PACKAGE;PAIR;ZONE;BELIEVE")
  set(odd ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES} ${arg_PACKAGE} ${arg_PAIR} ${arg_ZONE})
  list(FILTER odd EXCLUDE REGEX "^[^=]+=.+$")
  if(odd OR arg_UNPARSED_ARGUMENTS OR NOT arg_URDF)
    message(FATAL_ERROR "flashbvh_add_robot(${name}): give URDF file and options with their values, "
      "PACKAGE as name=folder, PAIR as link,link=length, ZONE as joint=length; not understood: ${odd}")
  endif()
  if(NOT name MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "flashbvh_add_robot(${name}): names in the code begin with the name; use letters, "
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
  foreach(option SRDF JOINT_LIMITS ${single})
    if(DEFINED arg_${option})
      string(TOLOWER --${option} flag)
      string(REPLACE "_" "-" flag ${flag})
      list(APPEND options ${flag} ${arg_${option}})
    endif()
  endforeach()
  if(arg_VISUAL_TOO)
    list(APPEND options --visual-too)
  endif()
  foreach(package IN LISTS arg_PACKAGE)
    string(REGEX MATCH "^[^=]+=" package_name "${package}")
    string(REGEX REPLACE "^[^=]+=" "" package_folder "${package}")
    get_filename_component(package_folder "${package_folder}" ABSOLUTE)
    list(APPEND options --package "${package_name}${package_folder}")
  endforeach()
  foreach(pair IN LISTS arg_PAIR)
    list(APPEND options --pair "${pair}")
  endforeach()
  foreach(zone IN LISTS arg_ZONE)
    list(APPEND options --zone "${zone}")
  endforeach()
  foreach(pair IN LISTS arg_BELIEVE)
    list(APPEND options --believe "${pair}")
  endforeach()
  if(NOT arg_FORMAT)
    set(arg_FORMAT c)
  elseif(NOT arg_FORMAT MATCHES "^(c|image|both)$")
    message(FATAL_ERROR "flashbvh_add_robot(${name}): FORMAT is c, image or both, not ${arg_FORMAT}")
  endif()
  flashbvh_robot_command(${name} ${arg_URDF} "${options}" "${depends}" ${arg_FORMAT})
endfunction()

# Adds the custom command and the library of the files that it makes.
function(flashbvh_robot_command name urdf options files format)
  cmake_policy(SET CMP0116 NEW)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/flashbvh/${name})
  set(stem ${folder}/${name}.robot)
  # This file changes with the options, because not every generator rebuilds if a command line changes.
  file(CONFIGURE OUTPUT ${folder}/options.txt CONTENT "${urdf};${options}" @ONLY)
  flashbvh_host_tool(program depends)
  set(made ${stem}.h ${stem}.c)
  if(format STREQUAL "image")
    set(made ${stem})
  elseif(format STREQUAL "both")
    list(APPEND made ${stem})
  endif()
  add_custom_command(OUTPUT ${made}
    COMMAND ${program} robot ${urdf} -o ${folder} --name ${name} --depfile ${stem}.d ${options}
    DEPENDS ${files} ${folder}/options.txt ${depends}
    DEPFILE ${stem}.d
    COMMENT "Baking ${name}"
    VERBATIM)
  set(kind PUBLIC)
  if(format STREQUAL "image")
    set(kind INTERFACE)
    add_library(${name} INTERFACE ${made})
  else()
    flashbvh_any_language(${made})
    add_library(${name} STATIC ${made})
  endif()
  add_library(${name}::${name} ALIAS ${name})
  target_include_directories(${name} ${kind} ${folder})
  target_link_libraries(${name} ${kind} flashbvh::robot)
endfunction()
