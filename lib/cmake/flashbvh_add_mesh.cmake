# flashbvh_add_mesh(name SOURCES mesh...
#                   [UNIT unit|mesh=unit...] [CELL length] [MAX_DEVIATION length]
#                   [LEAF_SIZE n] [ARITY n] [BUILDER name] [LAYOUT pre|post] [INDEX_BITS 16|32]
#                   [DROP degenerate|duplicate...] [MAX_BYTES n] [NAME name]
#                   [FORMAT cpp|image|both|c])
#
# A library `name`, also called name::name, with the baked trees of some meshes, which share one
# cell. A target that links it includes a mesh's tree as "<stem>.fbvh.hpp". The options are those of
# `flashbvh bake`. The meshes are baked anew when one of them, an option or the tool changes.
#
# FORMAT image makes no code: the folder of the images <stem>.fbvh is an include folder of whoever
# links the library, for .incbin; the target's property FLASHBVH_IMAGES lists them. FORMAT both does
# both. FORMAT c makes C of the images: "<stem>.fbvh.h" declares the array <stem>_image, for
# flashbvh_open().
include(${CMAKE_CURRENT_LIST_DIR}/host_tool.cmake)

function(flashbvh_add_mesh name)
  set(single CELL MAX_DEVIATION LEAF_SIZE ARITY BUILDER LAYOUT INDEX_BITS MAX_BYTES NAME FORMAT)
  set(repeated UNIT DROP)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "${single}" "SOURCES;${repeated}")
  set(odd ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES} ${arg_SOURCES})
  list(FILTER odd EXCLUDE REGEX "\\.([Ss][Tt][Ll]|[Oo][Bb][Jj]|[Pp][Ll][Yy]|[Oo][Ff][Ff]|[Dd][Aa][Ee]|[Gg][Ll][Tt][Ff]|[Gg][Ll][Bb]|3[Mm][Ff])$")
  if(odd OR NOT arg_SOURCES)
    message(FATAL_ERROR "flashbvh_add_mesh(${name}): give SOURCES mesh... and options with their "
      "values; not understood: ${odd}")
  endif()
  if(NOT DEFINED arg_FORMAT)
    set(arg_FORMAT cpp)
  endif()
  set(format ${arg_FORMAT})
  if(format STREQUAL "c")
    set(arg_FORMAT image)
  endif()
  set(options "")
  foreach(option ${single} ${repeated})
    string(TOLOWER --${option} flag)
    string(REPLACE "_" "-" flag ${flag})
    foreach(value IN LISTS arg_${option})
      list(APPEND options ${flag} ${value})
    endforeach()
  endforeach()
  flashbvh_bake_command(${name} "${arg_SOURCES}" "${options}" "${arg_NAME}" ${format})
endfunction()

# The custom command and the library that holds what it makes.
function(flashbvh_bake_command name sources options stem format)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/flashbvh/${name})
  set(meshes "")
  set(code "")
  set(images "")
  foreach(source ${sources})
    get_filename_component(mesh ${source} ABSOLUTE)
    list(APPEND meshes ${mesh})
    if(NOT stem)
      get_filename_component(mesh_stem ${source} NAME_WLE)
    else()
      set(mesh_stem ${stem})
    endif()
    list(APPEND code ${folder}/${mesh_stem}.fbvh.cpp ${folder}/${mesh_stem}.fbvh.hpp)
    list(APPEND images ${folder}/${mesh_stem}.fbvh)
  endforeach()
  if(format STREQUAL "cpp")
    set(images "")
  elseif(format STREQUAL "image" OR format STREQUAL "c")
    set(code "")
  endif()

  # A file that changes with the options: not every generator minds how a command is called.
  file(CONFIGURE OUTPUT ${folder}/options.txt CONTENT "${meshes};${options}" @ONLY)
  flashbvh_host_tool(program depends)
  add_custom_command(OUTPUT ${code} ${images}
    COMMAND ${program} bake ${meshes} -o ${folder} ${options}
    DEPENDS ${meshes} ${folder}/options.txt ${depends}
    COMMENT "Baking ${name}"
    VERBATIM)
  if(format STREQUAL "c")
    flashbvh_image_arrays(code "${images}")
  endif()
  if(code)
    add_library(${name} STATIC ${code} ${images})
    set(visibility PUBLIC)
  else()
    add_library(${name} INTERFACE ${images})
    set(visibility INTERFACE)
  endif()
  add_library(${name}::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES FLASHBVH_IMAGES "${images}")
  target_include_directories(${name} ${visibility} ${folder})
  target_link_libraries(${name} ${visibility} flashbvh::flashbvh)
endfunction()

# Sets `code` to the C files of the images, each made when its image changes.
function(flashbvh_image_arrays code images)
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/image_to_c.cmake)
  set(files "")
  foreach(image ${images})
    add_custom_command(OUTPUT ${image}.c ${image}.h
      COMMAND ${CMAKE_COMMAND} -DIMAGE=${image} -DSOURCE=${image}.c -DHEADER=${image}.h -P ${script}
      DEPENDS ${image} ${script}
      VERBATIM)
    list(APPEND files ${image}.c ${image}.h)
  endforeach()
  set(${code} ${files} PARENT_SCOPE)
endfunction()
