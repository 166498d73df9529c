# cmake [-DSTATUS=n] [-DOUTPUT=regex] -P expect.cmake -- COMMAND ARGUMENT...
#
# Runs the command and fails unless it ends with status n (0 by default; "failure" is any other) and
# its output matches the expression. CTest alone checks only one of the two at a time.
if(NOT DEFINED STATUS)
  set(STATUS 0)
endif()

set(command "")
set(past_separator FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(past_separator)
    string(REPLACE ";" "\\;" argument "${CMAKE_ARGV${i}}")
    list(APPEND command "${argument}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(past_separator TRUE)
  endif()
endforeach()

execute_process(COMMAND ${command}
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")

if(STATUS STREQUAL "failure")
  if(status EQUAL 0)
    message(FATAL_ERROR "ended with status 0, expected a failure")
  endif()
elseif(NOT status STREQUAL STATUS)
  message(FATAL_ERROR "ended with status ${status}, expected ${STATUS}")
endif()
if(DEFINED OUTPUT AND NOT output MATCHES "${OUTPUT}")
  message(FATAL_ERROR "the output does not match: ${OUTPUT}")
endif()
