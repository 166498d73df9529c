# flashbvh_add_mesh(name SOURCES mesh...
#                   [UNIT unit|mesh=unit...] [CELL length] [OWN_CELL] [MAX_DEVIATION length]
#                   [SIMPLIFY length] [FIT bytes] [LEAF_SIZE n] [ARITY n] [BUILDER name] [LAYOUT pre|post] [INDEX_BITS 16|32]
#                   [DROP degenerate|duplicate...] [LEVELS] [DEFORMABLE] [NAME name]
#                   [FORMAT c|image|both])
#
# Adds a library `name`, also called name::name, with the images of some meshes, which share one cell. A
# target that links it includes "<stem>.fbvh.h", for C and C++, which declares the array <stem>_image
# for view_unchecked(). The options are those of `flashbvh bake`. The build bakes the meshes again if
# one of them, an option or the tool changes.
#
# FORMAT image makes no code: each target that links the library gets the folder of the images
# <stem>.fbvh as an include folder, for .incbin; the property FLASHBVH_IMAGES of `name` lists them. FORMAT both
# makes arrays and images. In projects without the language C, C++ compiles the arrays.
#
# A target that links two such libraries does not configure unless they have the same CELL: a query
# on meshes with different cells ends with cell_mismatch. OWN_CELL means that no query combines the
# meshes with another library's.
include(${CMAKE_CURRENT_LIST_DIR}/host_tool.cmake)

function(flashbvh_add_mesh name)
  set(single CELL MAX_DEVIATION SIMPLIFY FIT LEAF_SIZE ARITY BUILDER LAYOUT INDEX_BITS NAME FORMAT)
  set(repeated UNIT DROP)
  cmake_parse_arguments(PARSE_ARGV 1 arg "LEVELS;DEFORMABLE;OWN_CELL" "${single}" "SOURCES;${repeated}")
  set(odd ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES} ${arg_SOURCES})
  list(FILTER odd EXCLUDE REGEX "\\.([Ss][Tt][Ll]|[Oo][Bb][Jj]|[Pp][Ll][Yy]|[Dd][Aa][Ee]|[Gg][Ll][Tt][Ff]|[Gg][Ll][Bb]|3[Mm][Ff])$")
  if(odd OR NOT arg_SOURCES)
    message(FATAL_ERROR "flashbvh_add_mesh(${name}): give SOURCES mesh... and options with their "
      "values; not understood: ${odd}")
  endif()
  if(NOT DEFINED arg_FORMAT)
    set(arg_FORMAT c)
  endif()
  flashbvh_set_options("LEVELS;DEFORMABLE" ${single} ${repeated})
  flashbvh_bake_meshes(${name} "${arg_SOURCES}" "${options}" "${arg_NAME}" ${arg_FORMAT})
  if(NOT arg_OWN_CELL)
    flashbvh_share_cell(${name} "${arg_CELL}")
  endif()
endfunction()

# CMake compares the property in each target that links several such libraries. Its error message
# shows the property's name, not its values, so the name explains the fix.
function(flashbvh_share_cell name cell)
  set(property "FLASHBVH_CELL [meshes that are queried together need the same cell: name them in one \
flashbvh_add_mesh(), or give each the same CELL, written alike; OWN_CELL for meshes that are not]")
  if(NOT cell)
    set(cell "as fine as ${name} fits")
  endif()
  set_target_properties(${name} PROPERTIES
    COMPATIBLE_INTERFACE_STRING "${property}" "INTERFACE_${property}" "${cell}")
endfunction()

function(flashbvh_bake_meshes name sources options stem format)
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
    list(APPEND code ${folder}/${mesh_stem}.fbvh.c ${folder}/${mesh_stem}.fbvh.h)
    list(APPEND images ${folder}/${mesh_stem}.fbvh)
  endforeach()
  if(format STREQUAL "image")
    set(code "")
  elseif(format STREQUAL "c")
    set(images "")
  endif()

  flashbvh_add_baked(${name} flashbvh::flashbvh ${folder} "${code}" "${images}" "bake;${meshes};${options}" "${meshes}")
  set_target_properties(${name} PROPERTIES FLASHBVH_IMAGES "${images}")
endfunction()
