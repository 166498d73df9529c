# Warnings are errors in all our own code. A build that only uses flashbvh chooses its own warnings.
option(FLASHBVH_WARNINGS "flashbvh's own warnings, as errors (GCC, Clang)" ${PROJECT_IS_TOP_LEVEL})

# flashbvh_warnings(target): sets the warnings of all our code, including tests and tools.
function(flashbvh_warnings target)
  if(NOT FLASHBVH_WARNINGS)
    return()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror)
  # Clang's -Wconversion includes signs in C++; GCC's does not.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
  if(FLASHBVH_SANITIZE)
    # With sanitizers, GCC reports "maybe uninitialized" values in the standard library.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()

# flashbvh_library_warnings(target): sets these warnings, those of signs, and on the boards a limit for every stack frame.
function(flashbvh_library_warnings target)
  flashbvh_warnings(${target})
  if(FLASHBVH_WARNINGS)
    target_compile_options(${target} PRIVATE -Wsign-conversion)
  endif()
  if(FLASHBVH_WARNINGS AND CMAKE_SYSTEM_NAME STREQUAL "Generic")
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wstack-usage=400>)
  endif()
endfunction()
