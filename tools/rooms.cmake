# The components (rooms) of the host program: each folder is a library. A room sees its own folder and
# the folders of all rooms that it uses, directly or not; other includes do not compile.

# flashbvh_as_one_source(target): compiles all sources as one, because the headers of the standard library, JSON
# and command line libraries take longer to compile than our code. -DCMAKE_UNITY_BUILD=OFF compiles each source
# separately.
function(flashbvh_as_one_source target)
  if(NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()

# Inlines small functions although the sanitizers' checks lengthen them.
set(flashbvh_inlined "")
if(FLASHBVH_SANITIZE)
  set(flashbvh_inlined -O2)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    list(APPEND flashbvh_inlined -mllvm -inline-threshold=1000)
  endif()
endif()

# flashbvh_room(SOURCES source... [USES room...] [OPTIMISED | INLINED]): adds flashbvh_FOLDER for the calling
# folder. In a fast build only OPTIMISED rooms are optimised, which takes three times as long to compile.
# INLINED: optimised, with the options above; for code that nearly all tests run.
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
  if(arg_INLINED)
    target_compile_options(flashbvh_${room} PRIVATE ${flashbvh_inlined})
  elseif(FLASHBVH_FAST_BUILD AND NOT arg_OPTIMISED)
    target_compile_options(flashbvh_${room} PRIVATE -O0)
  endif()
endfunction()

# flashbvh_need_room(room): adds a room, in builds of parts of the program.
function(flashbvh_need_room room)
  if(NOT TARGET flashbvh_${room})
    add_subdirectory(${FLASHBVH_SOURCE_DIR}/tools/${room} ${PROJECT_BINARY_DIR}/tools/${room}
      EXCLUDE_FROM_ALL)
  endif()
endfunction()
