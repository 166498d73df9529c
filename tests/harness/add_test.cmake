# flashbvh_add_test(name source... [HEAP] [LIBRARIES library...] [TIMEOUT seconds] [ICOUNT] [LONG] [OPTIMISED])
#
# Adds a program of Catch2 tests for this machine or, when crossing, for the board. CTest runs it as "<preset>/<name>".
# HEAP: the tests need a heap and the C++ library, so they run on this machine alone. All others run on every board,
# down to 8 KB of RAM. ICOUNT: instruction counts on the board are exact. LONG: a label of tests that run separately.
# OPTIMISED: optimised in a fast build, too.
# Tests that link nothing but what is listed below get the label `library`: of the host program no more than the rooms
# that bake meshes and robots in the test. The target library_tests builds them, for the preset dev.
function(flashbvh_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HEAP;ICOUNT;LONG;OPTIMISED" "TIMEOUT" "LIBRARIES")
  if(arg_HEAP AND FLASHBVH_BOARD)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  set(labels "")
  set(components ${arg_LIBRARIES})
  list(FILTER components EXCLUDE REGEX
    "^(flashbvh::robot|flashbvh_(golden|kept_images|small_trees|test_(arm_images|arms|near|support))|gmp(xx)?)$")
  if(arg_LONG)
    set(labels LABELS long)
  elseif(NOT components)
    set(labels LABELS library)
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

  # The emulator's own limit comes first: it reports the cause.
  math(EXPR limit "${arg_TIMEOUT} + 30")
  set(environment FLASHBVH_TIMEOUT=${arg_TIMEOUT})
  # The output names each test case, so that a crash can be located.
  set(each_named --durations yes)
  if(FLASHBVH_BOARD)
    set(each_named "")
    set_target_properties(${name} PROPERTIES SUFFIX ${FLASHBVH_SUFFIX})
    if(arg_ICOUNT)
      list(APPEND environment FLASHBVH_ICOUNT=${FLASHBVH_ICOUNT_SHIFT})
    elseif(FLASHBVH_RAM_KB GREATER_EQUAL 256)
      target_compile_options(${name} PRIVATE -O1)  # compiles a third faster; needs more stack
    endif()
  endif()
  set(test "${FLASHBVH_TEST_PREFIX}/${name}")
  add_test(NAME ${test} COMMAND ${name} ${each_named})
  set_tests_properties(${test} PROPERTIES FAIL_REGULAR_EXPRESSION "No tests ran" TIMEOUT ${limit} ${labels}
    ENVIRONMENT "${environment}")
endfunction()

# flashbvh_add_tests(room [OPTIMISED]): the tests of the folder `room`. A file's suffix selects where it runs:
#   *_board_test.cpp  on this machine and on every board; the target board_tests builds them all
#   *_host_test.cpp   on this machine, optimised, with GMP for exact rationals
#   *_long_test.cpp   on this machine, separately (LONG)
#   *_test.cpp        on this machine; OPTIMISED is for these
function(flashbvh_add_tests room)
  file(GLOB all CONFIGURE_DEPENDS ${room}/*_test.cpp)
  foreach(kind board host long)
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
  list(APPEND programs ${room}_test ${room}_host_test ${room}_long_test)
  set(support HEAP LIBRARIES flashbvh_test_support)
  if(all)
    flashbvh_add_test(${room}_test ${all} ${ARGN} TIMEOUT 600 ${support})
  endif()
  if(host)
    flashbvh_add_test(${room}_host_test ${host} OPTIMISED ${support} gmpxx gmp)
  endif()
  if(long)
    flashbvh_add_test(${room}_long_test ${long} LONG ${support})
  endif()
  # Internal headers of the library with several forms of one definition.
  foreach(program IN LISTS programs)
    if(TARGET ${program})
      target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/lib/src)
    endif()
  endforeach()
endfunction()
