# cmake -DNM=... -DLIBRARY=libflashbvh.a -P check_symbols.cmake
#
# The library's symbols: no writable data, and nothing called from outside but what calls.txt has,
# memory functions and the compiler's own arithmetic with integers. A heap, exceptions, RTTI or
# floats would show here even without a call.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/calls.txt allowed REGEX "^outside ")
list(TRANSFORM allowed REPLACE "^outside " "")
list(JOIN allowed "|" allowed)

execute_process(COMMAND ${NM} ${LIBRARY} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
set(defined "")
set(called "")
foreach(line IN LISTS symbols)
  if(line MATCHES " [BbDdCSs] (.*)$")
    message(SEND_ERROR "static data in the library: ${CMAKE_MATCH_1}")
  elseif(line MATCHES "^ +[Uvw] (.*)$")
    list(APPEND called ${CMAKE_MATCH_1})
  elseif(line MATCHES " [TtWVRrn] (.*)$")
    list(APPEND defined ${CMAKE_MATCH_1})
  elseif(line MATCHES "^[0-9a-f]+ . ")
    message(SEND_ERROR "a symbol of an unknown kind: ${line}")
  endif()
endforeach()
if(NOT defined)
  message(FATAL_ERROR "${LIBRARY} has no symbols")
endif()
list(REMOVE_DUPLICATES called)
# Whether ours are there is the linker's business.
list(FILTER called EXCLUDE REGEX "^_ZNK?8flashbvh")
list(REMOVE_ITEM called ${defined})
foreach(symbol IN LISTS called)
  if(NOT symbol MATCHES "^(${allowed})$")
    message(SEND_ERROR "the library needs ${symbol}")
  endif()
endforeach()
list(JOIN called " " called)
message(STATUS "from outside: ${called}")
