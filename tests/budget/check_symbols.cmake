# cmake -DNM=... -DLIBRARY=libflashbvh.a -P check_symbols.cmake
#
# The library's symbols: no writable data, and nothing called from outside but memory functions and
# the compiler's own arithmetic with integers. A heap, exceptions or RTTI would show here even if
# nobody called.
execute_process(COMMAND ${NM} -C ${LIBRARY} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
set(found 0)
foreach(line IN LISTS symbols)
  if(line MATCHES " [BbDdCSs] (.*)$")
    message(SEND_ERROR "static data in the library: ${CMAKE_MATCH_1}")
  elseif(line MATCHES "^ +U (__aeabi_(f|d|c[fd]|u?[il]2)[a-z0-9]*)$")
    message(SEND_ERROR "the library calculates in floating point: ${CMAKE_MATCH_1}")
  elseif(line MATCHES "^ +U (.*)$" AND
      NOT CMAKE_MATCH_1 MATCHES "^(flashbvh::|memcpy$|memset$|memmove$|__aeabi_|__gnu_thumb1_case_)")
    message(SEND_ERROR "the library needs ${CMAKE_MATCH_1}")
  elseif(line MATCHES " [TtWR] ")
    math(EXPR found "${found} + 1")
  endif()
endforeach()
if(found EQUAL 0)
  message(FATAL_ERROR "${LIBRARY} has no symbols")
endif()
