# flashbvh_add_mesh(name SOURCES mesh... [CELL length] [LAYOUT pre|post] [LEAF_SIZE n])
#
# A static library with the baked trees of some meshes, which share one cell. Include a mesh's
# tree as "<stem>.fbvh.hpp". The meshes are baked anew when they or the tool change.
#
# The tool runs on this machine. In a cross build it is FLASHBVH_HOST_TOOL or, if that is empty, a
# build of its own in the build folder.
set(FLASHBVH_HOST_TOOL "" CACHE FILEPATH "the program flashbvh, built for this machine")

# Sets `command` to the host tool and `depends` to what has to be there before it runs.
function(flashbvh_host_tool command depends)
  if(TARGET flashbvh_tool)
    set(${command} flashbvh_tool PARENT_SCOPE)
    set(${depends} flashbvh_tool PARENT_SCOPE)
    return()
  endif()
  if(FLASHBVH_HOST_TOOL)
    set(${command} ${FLASHBVH_HOST_TOOL} PARENT_SCOPE)
    set(${depends} ${FLASHBVH_HOST_TOOL} PARENT_SCOPE)
    return()
  endif()
  set(folder ${CMAKE_BINARY_DIR}/flashbvh-host)
  if(NOT TARGET flashbvh_host_build)
    include(ExternalProject)
    # The environment of a cross build must not reach the build for this machine.
    set(clean ${CMAKE_COMMAND} -E env --unset=CC --unset=CXX --unset=CFLAGS --unset=CXXFLAGS
      --unset=LDFLAGS --unset=CMAKE_TOOLCHAIN_FILE)
    ExternalProject_Add(flashbvh_host_build
      SOURCE_DIR ${FLASHBVH_SOURCE_DIR}
      BINARY_DIR ${folder}
      CONFIGURE_COMMAND ${clean} ${CMAKE_COMMAND} -G ${CMAKE_GENERATOR} -S <SOURCE_DIR>
        -B <BINARY_DIR> -DCMAKE_BUILD_TYPE=Release
      BUILD_COMMAND ${clean} ${CMAKE_COMMAND} --build <BINARY_DIR> --target flashbvh_tool
      BUILD_ALWAYS TRUE
      BUILD_BYPRODUCTS ${folder}/bin/flashbvh
      INSTALL_COMMAND "")
  endif()
  set(${command} ${folder}/bin/flashbvh PARENT_SCOPE)
  set(${depends} flashbvh_host_build ${folder}/bin/flashbvh PARENT_SCOPE)
endfunction()
set(FLASHBVH_SOURCE_DIR ${PROJECT_SOURCE_DIR} CACHE INTERNAL "")

function(flashbvh_add_mesh name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CELL;LAYOUT;LEAF_SIZE" "SOURCES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "flashbvh_add_mesh(${name}): SOURCES mesh... and options only; "
      "not understood: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name})
  set(options --format cpp)
  foreach(option CELL LAYOUT LEAF_SIZE)
    if(DEFINED arg_${option})
      string(TOLOWER ${option} flag)
      string(REPLACE "_" "-" flag ${flag})
      list(APPEND options --${flag} ${arg_${option}})
    endif()
  endforeach()
  set(meshes "")
  set(baked "")
  foreach(source ${arg_SOURCES})
    get_filename_component(mesh ${source} ABSOLUTE)
    get_filename_component(stem ${source} NAME_WLE)
    list(APPEND meshes ${mesh})
    list(APPEND baked ${folder}/${stem}.fbvh.cpp ${folder}/${stem}.fbvh.hpp)
  endforeach()
  flashbvh_host_tool(tool depends)
  add_custom_command(OUTPUT ${baked}
    COMMAND ${tool} bake ${meshes} -o ${folder} ${options}
    DEPENDS ${meshes} ${depends}
    COMMENT "Baking ${name}"
    VERBATIM)
  add_library(${name} STATIC ${baked})
  target_include_directories(${name} PUBLIC ${folder})
  target_link_libraries(${name} PUBLIC flashbvh::flashbvh)
endfunction()
