# flashbvh_add_robot(name URDF file [VISUAL_TOO]
#                    [PACKAGE name=folder]... [SRDF file] [BELIEVE link,link]... [CELL length] [LEAF_SIZE n]
#                    [SIMPLIFY length] [FIT bytes] [STOP length]
#                    [WARN length] [PAIR link,link=stop[,warn]]... [ZONE joint=length]... [TIME seconds] [FORMAT c|image|both])
#
# Adds a library `name`, also called name::name, with the image of a robot. A target that links it
# includes "<name>.robot.h", for C and C++, which declares the array <name>_robot_image for
# view_robot_unchecked(), and has flashbvh::robot. FORMAT image makes no code: each target that links the
# library gets the folder of <name>.robot, an image for open_robot(), as an include folder, for .incbin.
# FORMAT both makes both. The options are those of `flashbvh robot`; lengths
# are in metres. The build bakes the robot again if its file, the SRDF, a mesh, an included
# file, an option or the tool changes; the tool lists the files in a depfile.
include(${CMAKE_CURRENT_LIST_DIR}/host_tool.cmake)

function(flashbvh_add_robot name)
  set(files URDF SRDF)
  set(single CELL LEAF_SIZE SIMPLIFY FIT STOP WARN TIME FORMAT)
  cmake_parse_arguments(PARSE_ARGV 1 arg "VISUAL_TOO" "${files};${single}" "PACKAGE;PAIR;ZONE;BELIEVE")
  set(odd ${arg_PACKAGE} ${arg_PAIR} ${arg_ZONE})
  list(FILTER odd EXCLUDE REGEX "^[^=]+=.+$")
  list(PREPEND odd ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES})
  if(odd OR NOT arg_URDF)
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
  set(packages ${arg_PACKAGE})
  set(arg_PACKAGE "")
  foreach(package IN LISTS packages)
    string(REGEX MATCH "^([^=]+=)(.*)" package "${package}")
    get_filename_component(package_folder "${CMAKE_MATCH_2}" ABSOLUTE)
    list(APPEND arg_PACKAGE "${CMAKE_MATCH_1}${package_folder}")
  endforeach()
  if(NOT arg_FORMAT)
    set(arg_FORMAT c)
  elseif(NOT arg_FORMAT MATCHES "^(c|image|both)$")
    message(FATAL_ERROR "flashbvh_add_robot(${name}): FORMAT is c, image or both, not ${arg_FORMAT}")
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/flashbvh/${name})
  set(image ${folder}/${name}.robot)
  set(code ${image}.h ${image}.c)
  if(arg_FORMAT STREQUAL "image")
    set(code "")
  elseif(arg_FORMAT STREQUAL "c")
    set(image "")
  endif()
  flashbvh_set_options(VISUAL_TOO SRDF ${single} PACKAGE PAIR ZONE BELIEVE)
  set(depfile ${folder}/${name}.robot.d)
  flashbvh_add_baked(${name} flashbvh::robot ${folder} "${code}" "${image}"
    "robot;${arg_URDF};--name;${name};--depfile;${depfile};${options}" "${depends}" DEPFILE ${depfile})
endfunction()
