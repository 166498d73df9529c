# Warnings are errors in everything that we write ourselves.

# flashbvh_warnings(target): the warnings of all our code, tests and tools included.
function(flashbvh_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror)
  if(FLASHBVH_SANITIZE)
    # GCC finds values "maybe uninitialized" in the standard library where the sanitizers add paths.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()

# flashbvh_library_warnings(target): those, and on the boards a bound on every stack frame.
function(flashbvh_library_warnings target)
  flashbvh_warnings(${target})
  target_compile_options(${target} PRIVATE $<$<BOOL:${CMAKE_CROSSCOMPILING}>:-Wstack-usage=256>)
endfunction()
