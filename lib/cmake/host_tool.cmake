# The program that bakes. It runs on this machine, whatever the target of the build is.
cmake_policy(VERSION 3.21)  # even if the caller requires an older CMake: Ninja needs its form of depfile
set(FLASHBVH_HOST_TOOL "" CACHE FILEPATH "the program flashbvh, built for this machine")

# Sets `program` to its path and `depends` to the files that must exist before it runs. Uses the first
# of: FLASHBVH_HOST_TOOL, the target of this build, the installed package's program, and a separate
# build in the build folder.
function(flashbvh_host_tool program depends)
  if(FLASHBVH_HOST_TOOL)
    if(NOT EXISTS ${FLASHBVH_HOST_TOOL})
      message(FATAL_ERROR "FLASHBVH_HOST_TOOL: there is no ${FLASHBVH_HOST_TOOL}; "
        "give the path of the program flashbvh, or nothing to have it built")
    endif()
    set(${program} ${FLASHBVH_HOST_TOOL} PARENT_SCOPE)
    set(${depends} ${FLASHBVH_HOST_TOOL} PARENT_SCOPE)
  elseif(TARGET flashbvh_tool)
    set(${program} $<TARGET_FILE:flashbvh_tool> PARENT_SCOPE)
    set(${depends} flashbvh_tool PARENT_SCOPE)
  elseif(TARGET flashbvh::flashbvh_tool)
    # The target's name is not used: CMake would run it in the emulator of a cross build.
    set(${program} $<TARGET_FILE:flashbvh::flashbvh_tool> PARENT_SCOPE)
    set(${depends} $<TARGET_FILE:flashbvh::flashbvh_tool> PARENT_SCOPE)
  elseif(FLASHBVH_SOURCE_DIR)
    flashbvh_build_host_tool(built)
    set(${program} ${built} PARENT_SCOPE)
    set(${depends} flashbvh_host_build ${built} PARENT_SCOPE)
  else()
    message(FATAL_ERROR "flashbvh was installed without its program, which bakes meshes; "
      "set FLASHBVH_HOST_TOOL to its path")
  endif()
endfunction()

# Sets `options` to the program's options for the caller's variables arg_NAME: a flag for each of the `switches` that is
# set, a flag with each value of the others.
function(flashbvh_set_options switches)
  set(options "")
  foreach(option ${switches} ${ARGN})
    string(TOLOWER --${option} flag)
    string(REPLACE "_" "-" flag ${flag})
    foreach(value IN LISTS arg_${option})
      if(NOT option IN_LIST switches)
        list(APPEND options ${flag} ${value})
      elseif(value)
        list(APPEND options ${flag})
      endif()
    endforeach()
  endforeach()
  set(options ${options} PARENT_SCOPE)
endfunction()

# Adds the command of the program that makes `code` and `images` in `folder`, and their library, which links `library`.
# More arguments are those of add_custom_command().
function(flashbvh_add_baked name library folder code images command depends)
  # This file changes with the options, because not every generator rebuilds if a command line changes.
  file(CONFIGURE OUTPUT ${folder}/options.txt CONTENT "${command}" @ONLY)
  flashbvh_host_tool(program program_depends)
  add_custom_command(OUTPUT ${code} ${images}
    COMMAND ${program} ${command} -o ${folder}
    DEPENDS ${depends} ${folder}/options.txt ${program_depends}
    COMMENT "Baking ${name}"
    VERBATIM ${ARGN})
  if(code)
    add_library(${name} STATIC ${code} ${images})
    if(NOT CMAKE_C_COMPILER_LOADED)
      list(FILTER code INCLUDE REGEX "\\.c$")  # valid C++, too
      set_source_files_properties(${code} PROPERTIES LANGUAGE CXX)
    endif()
    set(visibility PUBLIC)
  else()
    add_library(${name} INTERFACE ${images})
    set(visibility INTERFACE)
  endif()
  add_library(${name}::${name} ALIAS ${name})
  target_include_directories(${name} ${visibility} ${folder})
  target_link_libraries(${name} ${visibility} ${library})
endfunction()

# Adds a separate build, independent of this build's flags, compiler, toolchain file and environment.
function(flashbvh_build_host_tool built)
  set(folder ${CMAKE_BINARY_DIR}/flashbvh-host)
  set(${built} ${folder}/bin/flashbvh PARENT_SCOPE)
  if(TARGET flashbvh_host_build)
    return()
  endif()
  include(ExternalProject)
  set(clean ${CMAKE_COMMAND} -E env)
  foreach(variable CC CXX CFLAGS CXXFLAGS LDFLAGS CPATH C_INCLUDE_PATH CPLUS_INCLUDE_PATH
      LIBRARY_PATH CMAKE_TOOLCHAIN_FILE CMAKE_GENERATOR CMAKE_GENERATOR_PLATFORM
      CMAKE_GENERATOR_TOOLSET CMAKE_BUILD_TYPE CMAKE_PREFIX_PATH DESTDIR)
    list(APPEND clean --unset=${variable})
  endforeach()
  string(REPLACE "Ninja Multi-Config" "Ninja" generator ${CMAKE_GENERATOR})
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  ExternalProject_Add(flashbvh_host_build
    PREFIX ${folder}/project
    SOURCE_DIR ${FLASHBVH_SOURCE_DIR}
    BINARY_DIR ${folder}
    CONFIGURE_COMMAND ${clean} ${CMAKE_COMMAND} -G ${generator}
      -DCMAKE_MAKE_PROGRAM=${CMAKE_MAKE_PROGRAM} -S <SOURCE_DIR> -B <BINARY_DIR>
      -DCMAKE_BUILD_TYPE=Release -DFLASHBVH_BUILD_TOOL=ON -DFLASHBVH_BUILD_TESTS=OFF
      -DFLASHBVH_WARNINGS=OFF
    BUILD_COMMAND ${clean} ${CMAKE_COMMAND} --build <BINARY_DIR> --target flashbvh_tool
      --parallel ${cores}
    BUILD_ALWAYS TRUE
    BUILD_BYPRODUCTS ${folder}/bin/flashbvh
    INSTALL_COMMAND "")
endfunction()
