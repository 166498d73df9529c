# Functions for programs that run on a board; tests with Catch2 are in tests/harness.

set(FLASHBVH_RUN ${PROJECT_SOURCE_DIR}/ports/run ${FLASHBVH_MACHINE} CACHE INTERNAL "")
set(FLASHBVH_EXPECT ${CMAKE_CURRENT_LIST_DIR}/expect.cmake CACHE INTERNAL "")
set(no_heap ${PROJECT_SOURCE_DIR}/ports/common/no_heap.ld)
set(suffix .elf)
if(FLASHBVH_ARCHITECTURE STREQUAL "wasm")  # its linker takes no scripts
  set(no_heap "")
  set(suffix .wasm)
endif()
set(FLASHBVH_NO_HEAP ${no_heap} CACHE INTERNAL "")
set(FLASHBVH_SUFFIX ${suffix} CACHE INTERNAL "")

# flashbvh_board_executable(name source...): the common part of firmware and tests.
function(flashbvh_board_executable name)
  add_executable(${name} ${ARGN})
  set_target_properties(${name} PROPERTIES SUFFIX ${FLASHBVH_SUFFIX})
  target_link_options(${name} PRIVATE -Wl,-Map=$<TARGET_FILE:${name}>.map)
  target_link_libraries(${name} PRIVATE flashbvh::flashbvh flashbvh_board)
endfunction()

# flashbvh_add_firmware(name source...)
#
# Builds name.elf and name.elf.map. The link fails if heap, exceptions or RTTI are linked in.
# main() has no arguments.
function(flashbvh_add_firmware name)
  flashbvh_board_executable(${name} ${ARGN})
  flashbvh_warnings(${name})
  target_link_libraries(${name} PRIVATE ${FLASHBVH_NO_HEAP})
  set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS ${FLASHBVH_NO_HEAP})
endfunction()

# flashbvh_add_firmware_test(name target [ICOUNT] [STATUS n] [PASS_REGULAR_EXPRESSION regex]
#                            [TIMEOUT seconds])
#
# Runs the firmware under QEMU. The test passes if the firmware ends with STATUS (0 unless given) and
# its output matches the expression, if one is given. ICOUNT makes instruction counts exact.
function(flashbvh_add_firmware_test name target)
  cmake_parse_arguments(PARSE_ARGV 2 arg
    "ICOUNT" "STATUS;PASS_REGULAR_EXPRESSION;TIMEOUT" "")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "flashbvh_add_firmware_test(${name}): unknown ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 60)
  endif()
  set(expectations "")
  if(DEFINED arg_STATUS)
    list(APPEND expectations -DSTATUS=${arg_STATUS})
  endif()
  if(DEFINED arg_PASS_REGULAR_EXPRESSION)
    string(REPLACE ";" "\\;" expression "${arg_PASS_REGULAR_EXPRESSION}")  # an argument, not a list
    list(APPEND expectations "-DOUTPUT=${expression}")
  endif()
  set(environment FLASHBVH_TIMEOUT=${arg_TIMEOUT})
  if(arg_ICOUNT)
    list(APPEND environment FLASHBVH_ICOUNT=${FLASHBVH_ICOUNT_SHIFT})
  endif()

  set(test "${FLASHBVH_TEST_PREFIX}/${name}")
  add_test(NAME ${test} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    COMMAND ${CMAKE_COMMAND} ${expectations} -P ${FLASHBVH_EXPECT} --
      ${FLASHBVH_RUN} $<TARGET_FILE:${target}>)
  # ports/run's own limit comes first, as its message says what happened.
  math(EXPR limit "${arg_TIMEOUT} + 30")
  set_tests_properties(${test} PROPERTIES TIMEOUT ${limit} ENVIRONMENT "${environment}")
endfunction()

# flashbvh_add_link_failure_test(name target OUTPUT regex)
#
# Passes if `target` does not build and the build's output matches `regex`.
function(flashbvh_add_link_failure_test name target)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "OUTPUT" "")
  set(test "${FLASHBVH_TEST_PREFIX}/${name}")
  set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  add_test(NAME ${test}
    COMMAND ${CMAKE_COMMAND} -DSTATUS=failure "-DOUTPUT=${arg_OUTPUT}" -P ${FLASHBVH_EXPECT} --
      ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target ${target})
  # A build folder allows one build at a time.
  set_tests_properties(${test} PROPERTIES TIMEOUT 120 RESOURCE_LOCK flashbvh_build_folder)
endfunction()
