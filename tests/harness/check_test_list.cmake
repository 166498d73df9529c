# cmake -DCOMMAND=... -P check_test_list.cmake
#
# Fails unless the Catch2 executable lists its tests: its exit status is then their number, in 8 bits.
execute_process(COMMAND ${COMMAND} --list-test-names-only
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
string(REGEX MATCHALL "[^\n]+" tests "${output}")
list(LENGTH tests count)
math(EXPR expected "${count} % 256")
if(count EQUAL 0 OR NOT status STREQUAL expected)
  message(FATAL_ERROR "${COMMAND} lists ${count} tests and ends with ${status}:\n${output}${errors}")
endif()
