# The rooms of the host program: folders that are a library each. A room sees its own folder and those
# of the rooms that it uses, and theirs; an include of any other does not compile.

# flashbvh_as_one_source(target): the standard library's headers and the JSON and command line
# libraries take longer to compile than all that is here. -DCMAKE_UNITY_BUILD=OFF compiles each source
# by itself.
function(flashbvh_as_one_source target)
  if(NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()

# In a fast build: small functions are inlined though the sanitizers' checks lengthen them.
set(flashbvh_inlined "")
if(FLASHBVH_FAST_BUILD)
  set(flashbvh_inlined -O2)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    list(APPEND flashbvh_inlined -mllvm -inline-threshold=1000)
  endif()
endif()

# flashbvh_room(SOURCES source... [USES room...] [OPTIMISED | INLINED]): flashbvh_FOLDER, of the folder
# that calls. In a fast build only what says so is OPTIMISED: it takes three times as long to compile.
# INLINED: with the options below, for what nearly all tests run.
function(flashbvh_room)
  cmake_parse_arguments(arg "OPTIMISED;INLINED" "" "SOURCES;USES" ${ARGN})
  get_filename_component(room ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  add_library(flashbvh_${room} STATIC ${arg_SOURCES})
  flashbvh_as_one_source(flashbvh_${room})
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/seen)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/seen/${room} SYMBOLIC)
  target_include_directories(flashbvh_${room} PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/seen)
  foreach(used ${arg_USES})
    flashbvh_need_room(${used})
    target_link_libraries(flashbvh_${room} PUBLIC flashbvh_${used})
  endforeach()
  flashbvh_warnings(flashbvh_${room})
  if(FLASHBVH_FAST_BUILD AND arg_INLINED)
    target_compile_options(flashbvh_${room} PRIVATE ${flashbvh_inlined})
  elseif(FLASHBVH_FAST_BUILD AND NOT arg_OPTIMISED)
    target_compile_options(flashbvh_${room} PRIVATE -O0)
  endif()
endfunction()

# flashbvh_need_room(room): for builds of parts of the program.
function(flashbvh_need_room room)
  if(NOT TARGET flashbvh_${room})
    add_subdirectory(${FLASHBVH_SOURCE_DIR}/tools/${room} ${PROJECT_BINARY_DIR}/tools/${room}
      EXCLUDE_FROM_ALL)
  endif()
endfunction()
