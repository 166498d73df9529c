# flashbvh_example(program source...): firmware, or a program on the host, where `host` replaces the board's headers.
function(flashbvh_example program)
  if(FLASHBVH_BOARD)
    flashbvh_add_firmware(${program} ${ARGN})
  else()
    add_executable(${program} ${ARGN})
    target_include_directories(${program} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/host)
    flashbvh_warnings(${program})
  endif()
  # Fused multiply-adds would change floats on some cores.
  target_compile_options(${program} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
endfunction()

# flashbvh_expected_test(name program expected [TIMEOUT seconds] [argument...]): the program prints the text of the
# file `expected` on every core and on the host, where it gets the arguments; # stands for any number.
function(flashbvh_expected_test name program expected)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "TIMEOUT" "")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${expected})
  file(READ ${expected} expected)
  string(REGEX REPLACE "[()]" "\\\\\\0" expected "${expected}")
  string(REPLACE "#" "[0-9]+" expected "${expected}")
  if(FLASHBVH_BOARD)
    flashbvh_add_firmware_test(${name} ${program} ICOUNT TIMEOUT "${arg_TIMEOUT}"
      PASS_REGULAR_EXPRESSION "^${expected}$")
  else()
    add_test(NAME "${FLASHBVH_TEST_PREFIX}/${name}"
      COMMAND ${CMAKE_COMMAND} "-DOUTPUT=^${expected}$"
        -P ${PROJECT_SOURCE_DIR}/ports/cmake/expect.cmake -- $<TARGET_FILE:${program}> ${arg_UNPARSED_ARGUMENTS})
  endif()
endfunction()
