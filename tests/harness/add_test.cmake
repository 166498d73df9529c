# flashbvh_add_test(name source... [HEAP] [LIBRARIES library...] [TIMEOUT seconds] [ICOUNT] [LONG]
#   [OPTIMISED])
#
# Adds an executable of Catch2 tests, for this machine or, when crossing, for the board. CTest runs it as
# "<preset>/<name>". The executable needs no main() of its own.
# HEAP: the tests need a heap. Boards without storage for one leave them out; so do all but the Cortex-M4F, unless
# FLASHBVH_ALL_TESTS or ICOUNT is set. All other tests run on every board, down to 8 KB of RAM, with
# tests/harness/small_catch, and link no heap.
# ICOUNT: instruction counts on the board are exact, and each test case is a test of CTest, "<preset>/<test case>";
# -R and -V show its figures. LONG: a label of tests that run separately. Tests that link nothing but what is
# listed below get the label `library`: of the host program no more than the rooms that bake meshes and robots in the
# test. The target library_tests builds them: the preset dev, tools/test.sh --quick.
# OPTIMISED: optimised in a fast build, too.
set(FLASHBVH_CHECK_TEST_LIST ${CMAKE_CURRENT_LIST_DIR}/check_test_list.cmake CACHE INTERNAL "")

function(flashbvh_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HEAP;ICOUNT;LONG;OPTIMISED" "TIMEOUT" "LIBRARIES")
  if(arg_HEAP AND NOT FLASHBVH_TESTS_HAVE_HEAP)
    return()
  endif()
  # On other cores, the tests without a heap and the digest cover the core's own code.
  if(arg_HEAP AND NOT arg_ICOUNT AND NOT FLASHBVH_ALL_TESTS AND FLASHBVH_BOARD
      AND NOT FLASHBVH_BOARD STREQUAL "mps2-an386")
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  set(labels "")
  set(components ${arg_LIBRARIES})
  list(FILTER components EXCLUDE REGEX
    "^(flashbvh::robot|flashbvh_(golden|kept_images|small_trees|test_(arm_images|arms|near|support))|gmp(xx)?)$")
  if(arg_LONG)
    set(labels LABELS long)
  elseif(NOT components)
    set(labels LABELS library)
  endif()
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  if("library" IN_LIST labels)
    add_dependencies(library_tests ${name})
  endif()
  target_sources(${name} PRIVATE $<TARGET_OBJECTS:flashbvh_harness>)
  target_link_libraries(${name} PRIVATE
    ${arg_LIBRARIES} flashbvh_test_queries flashbvh::flashbvh flashbvh_harness_options)
  flashbvh_warnings(${name})
  if(FLASHBVH_FAST_BUILD)
    set(headers flashbvh_test_headers)
    set(level -O0)
    if(arg_OPTIMISED)
      set(headers flashbvh_test_headers_O1)
      set(level -O1)
    endif()
    target_compile_options(${name} PRIVATE -g1 ${level})
    # As in the host program (tools/cli): optimised templates come first.
    set(first flashbvh_test_queries flashbvh)
    list(TRANSFORM first REPLACE "(.+)" "$<TARGET_FILE:\\1>")
    target_link_options(${name} PRIVATE -Wl,--whole-archive ${first} -Wl,--no-whole-archive)
    target_precompile_headers(${name} REUSE_FROM ${headers})
  endif()
  if(CMAKE_CROSSCOMPILING)
    # Compiles a third faster. Not for tests that count instructions, nor for boards with little stack.
    if(FLASHBVH_TESTS_HAVE_HEAP AND NOT arg_ICOUNT)
      target_compile_options(${name} PRIVATE -O1)
    endif()
    set_target_properties(${name} PROPERTIES SUFFIX ${FLASHBVH_SUFFIX})
    # The test property ENVIRONMENT does not serve: catch_discover_tests() passes at most one variable.
    if(arg_ICOUNT)
      # Figures are printed with fractions; newlib's small printf() needs this option for them.
      if(CMAKE_CXX_FLAGS MATCHES "nano.specs")
        target_link_options(${name} PRIVATE -Wl,-u,_printf_float)
      endif()
      set_target_properties(${name} PROPERTIES CROSSCOMPILING_EMULATOR
        "${CMAKE_COMMAND};-E;env;FLASHBVH_ICOUNT=${FLASHBVH_ICOUNT_SHIFT};${FLASHBVH_RUN}")
    endif()
  endif()

  # The emulator's own limit comes first: it reports the cause.
  math(EXPR limit "${arg_TIMEOUT} + 30")
  set(properties TIMEOUT ${limit} ${labels} ENVIRONMENT FLASHBVH_TIMEOUT=${arg_TIMEOUT})
  if(CMAKE_CROSSCOMPILING AND arg_ICOUNT)
    # Catch2 treats an executable that crashes as one without tests.
    add_custom_command(TARGET ${name} POST_BUILD VERBATIM
      COMMAND ${CMAKE_COMMAND} "-DCOMMAND=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:${name}>"
        -P ${FLASHBVH_CHECK_TEST_LIST})
    catch_discover_tests(${name} TEST_PREFIX "${FLASHBVH_TEST_PREFIX}/" PROPERTIES ${properties})
    return()
  endif()
  # The output names each test case, so that a crash can be located.
  set(each_named "")
  if(NOT CMAKE_CROSSCOMPILING)
    set(each_named --durations yes)
  endif()
  set(test "${FLASHBVH_TEST_PREFIX}/${name}")
  add_test(NAME ${test} COMMAND ${name} ${each_named})
  set_tests_properties(${test} PROPERTIES FAIL_REGULAR_EXPRESSION "No tests ran" ${properties})
endfunction()

# flashbvh_add_tests(room [OPTIMISED]): the tests of the folder `room`. A file's suffix selects where it runs:
#                     the target board_tests builds them all
#   *_cost_test.cpp   on boards of measured cores, counting instructions
#   *_host_test.cpp   only on this machine, optimised, with GMP for exact rationals
#   *_long_test.cpp   only on this machine, separately (LONG)
#   *_test.cpp        on this machine and on boards with a heap; OPTIMISED is for these
function(flashbvh_add_tests room)
  file(GLOB all CONFIGURE_DEPENDS ${room}/*_test.cpp)
  foreach(kind board cost host long)
    set(${kind} ${all})
    list(FILTER ${kind} INCLUDE REGEX "_${kind}_test.cpp$")
  endforeach()
  list(FILTER all EXCLUDE REGEX "_(board|cost|host|long)_test.cpp$")
  set(programs "")
  foreach(source IN LISTS board)
    get_filename_component(name ${source} NAME_WE)
    flashbvh_add_test(${room}_${name} ${source} LIBRARIES flashbvh_small_trees)
    list(APPEND programs ${room}_${name})
  endforeach()
  if(programs)
    add_dependencies(board_tests ${programs})
  endif()
  list(APPEND programs ${room}_test ${room}_cost_test ${room}_host_test ${room}_long_test)
  set(support HEAP LIBRARIES flashbvh_test_support)
  if(all)
    flashbvh_add_test(${room}_test ${all} ${ARGN} TIMEOUT 600 ${support})
  endif()
  if(cost AND is_measured)
    flashbvh_add_test(${room}_cost_test ${cost} ICOUNT ${support})
  endif()
  if(host AND NOT CMAKE_CROSSCOMPILING)
    flashbvh_add_test(${room}_host_test ${host} OPTIMISED ${support} gmpxx gmp)
  endif()
  if(long AND NOT CMAKE_CROSSCOMPILING)
    flashbvh_add_test(${room}_long_test ${long} LONG ${support})
  endif()
  # Internal headers of the library with several forms of one definition.
  foreach(program IN LISTS programs)
    if(TARGET ${program})
      target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/lib/src)
    endif()
  endforeach()
endfunction()
