# cmake -P check_test_list.cmake -- COMMAND...
#
# Fails unless the Catch2 executable lists its tests: its exit status is then their number, in the
# 8 bits that there are.
set(command "")
set(past_separator FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(past_separator)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(past_separator TRUE)
  endif()
endforeach()

execute_process(COMMAND ${command} --list-test-names-only
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
string(REGEX MATCHALL "[^\n]+" tests "${output}")
list(LENGTH tests count)
math(EXPR expected "${count} % 256")
if(count EQUAL 0 OR NOT status STREQUAL expected)
  message(FATAL_ERROR "${command} lists ${count} tests and ends with ${status}:\n${output}${errors}")
endif()
