# Warnings are errors in everything that we write ourselves; in a build that only uses flashbvh they
# are its own business.
option(FLASHBVH_WARNINGS "flashbvh's own warnings, as errors (GCC, Clang)" ${PROJECT_IS_TOP_LEVEL})

# flashbvh_warnings(target): the warnings of all our code, tests and tools included.
function(flashbvh_warnings target)
  if(NOT FLASHBVH_WARNINGS)
    return()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror)
  # In Clang's C++ -Wconversion is also about signs, in GCC's it is not.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
  if(FLASHBVH_SANITIZE)
    # GCC finds values "maybe uninitialized" in the standard library where the sanitizers add paths.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()

# flashbvh_library_warnings(target): those, and on the boards a bound on every stack frame.
function(flashbvh_library_warnings target)
  flashbvh_warnings(${target})
  if(FLASHBVH_WARNINGS AND CMAKE_SYSTEM_NAME STREQUAL "Generic")
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wstack-usage=400>)
  endif()
endfunction()
